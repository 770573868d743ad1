// Square bars that meet at an angle.
#pragma once

#include "tests/updating/support/deck_support.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <string>

namespace tapfit::structure::corner_decks {

inline constexpr double depth = 0.02;
inline constexpr double pitch = 0.025;
inline constexpr int per_leg = 8;

// Two legs of square bar at an angle, in the plane x-z, clamped at the first's
// foot; `rigid` metres of each leg at the corner are rigid arms.
inline Deck two_legs(double degrees, double rigid) {
  const double a = degrees * std::acos(-1.0) / 180.0;
  std::string text = "BEGIN BULK\nPARAM,COUPMASS,1\n";
  for (int i = 0; i <= 2 * per_leg; ++i) {
    const double first = pitch * std::min(i, per_leg);
    const double second = pitch * std::max(i - per_leg, 0);
    text += fmt::format("GRID,{},,{},0.,{},,246\n",
                        i + 1,
                        second * std::sin(a),
                        first + second * std::cos(a));
  }
  for (int i = 1; i <= 2 * per_leg; ++i) {
    text += fmt::format("CBAR,{},1,{},{},0.,1.,0.\n", i, i, i + 1);
    if (rigid > 0.0 && i == per_leg) {
      text += fmt::format(",,,,,,0.,0.,{}\n", -rigid);
    }
    if (rigid > 0.0 && i == per_leg + 1) {
      text += fmt::format(
          ",,,{},0.,{}\n", rigid * std::sin(a), rigid * std::cos(a));
    }
  }
  // Arms weigh nothing: what they replace stays at the corner.
  if (rigid > 0.0) {
    text += fmt::format(
        "CONM2,99,{},,{}\n", per_leg + 1, 2.0 * rigid * depth * depth * 7850.0);
  }
  text += fmt::format(
      "PBAR,1,1,{0},{1},{1},2e-8\n", depth * depth, std::pow(depth, 4) / 12.0);
  return deck_of(text + "MAT1,1,2.1+11,,.3,7850.\nSPC1,1,123456,1\nENDDATA\n");
}

// A member of square bar along x, and one that ends at its middle; `beyond`
// goes on at the other side.
inline Deck meeting(bool beyond) {
  std::string text = "BEGIN BULK\nPARAM,COUPMASS,1\n";
  text += "GRID,1,,-.1,0.,0.\nGRID,2,,0.,0.,0.\nGRID,3,,.1,0.,0.\n";
  text += "GRID,4,,0.,.025,0.\nGRID,5,,0.,-.025,0.\n";
  text += "CBAR,1,1,1,2,0.,0.,1.\nCBAR,2,1,2,3,0.,0.,1.\n";
  text += "CBAR,3,1,2,4,0.,0.,1.\n";
  if (beyond) text += "CBAR,4,1,5,2,0.,0.,1.\n";
  text += fmt::format("PBAR,1,1,{0},{1},{1},2e-8,3.\n",
                      depth * depth,
                      std::pow(depth, 4) / 12.0);
  return deck_of(text + "MAT1,1,2.1+11,,.3,7850.\nSPC1,1,123456,1\nENDDATA\n");
}

}  // namespace tapfit::structure::corner_decks
