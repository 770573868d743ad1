// Where the masses of named sensors, or at named points, load a test.
#pragma once

#include "signal/mass_removal/free_frfs.hpp"

#include <cstddef>
#include <string>
#include <vector>

namespace tapfit::signal {

struct ChannelMass {
  std::size_t channel = 0;  ///< index into TestBundle::channels
  KnownMass mass;
};

/// Masses that go where their channel goes, in every direction that is
/// measured there: channels of one sensor at one grid carry one mass.
///
/// @throws InputError when two of the channels sit at one grid with different
///   masses
[[nodiscard]] LoadedTest sensors_as_loads(
    const FrfSet& frfs, const std::vector<ChannelMass>& masses);

struct PointMass {
  Dof dof;
  KnownMass mass;
};

/// Masses that stay at their points while all FRFs are measured.
[[nodiscard]] LoadedTest points_as_loads(const FrfSet& frfs,
                                         const std::vector<PointMass>& masses);

}  // namespace tapfit::signal
