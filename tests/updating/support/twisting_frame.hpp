// A frame of two legs that twists as it bends.
#pragma once

#include "updating/structure/deck/deck.hpp"

#include <Eigen/Core>

namespace tapfit::updating::testing {

/// An L of aluminium in the plane of x and y, 0.35 m and 0.2 m in twelve grids,
/// free or clamped at the end of its longer leg, grid 1. Its bars have no
/// inertia of their own against twisting: what twists the first leg is an
/// answer to the force that holds it alone.
inline structure::Deck twisting_frame(bool clamped) {
  structure::Deck deck;
  deck.path = "frame.bdf";
  deck.coupled_mass = true;
  deck.materials[1] = {1, false, 70e9, 0.33, 70e9 / 2.66, 2700, 0, 0, 0};
  deck.bar_properties[1] = {1, 1, 1.6e-4, 3.4e-9, 1.3e-9, 0.0, 3e-9};
  for (int i = 1; i <= 12; ++i) {
    const double x = 0.05 * (i < 8 ? i - 1 : 7);
    const double y = i < 9 ? 0.0 : 0.05 * (i - 8);
    deck.grids.push_back({i, {x, y, 0.0}});
  }
  if (clamped) deck.constraints.push_back({1, "123456"});
  for (int i = 1; i < 12; ++i) {
    structure::Bar bar = structure::make_bar(i, 1, i, i + 1);
    bar.orientation = Eigen::Vector3d::UnitZ();
    deck.bars.push_back(bar);
  }
  return deck;
}

}  // namespace tapfit::updating::testing
