// Positions that are gathered where there are more than a measurement could
// tell apart: a fine mesh has as many places as a coarse one.
#pragma once

#include <Eigen/Core>

#include <cstddef>
#include <vector>

namespace tapfit::updating {

/// So many places of one kind are looked at on a structure, however fine its
/// mesh: along a square plate 26 each way, five or more in each half wave of
/// the tens of modes that a hammer excites.
inline constexpr std::size_t most_places = 700;
/// And so many lines across it that run about alike.
inline constexpr std::size_t most_lines = 60;

/// @return positions that count as one, by number, ascending; each by itself
///   where there are no more than `most`, else those in one of equal cubes,
///   the smallest that leave no more
[[nodiscard]] std::vector<std::vector<std::size_t>> gathered(
    const std::vector<Eigen::Vector3d>& at, std::size_t most = most_places);

/// One for each of gathered(), the nearest to the middle of its group.
[[nodiscard]] std::vector<std::size_t> spread_out(
    const std::vector<Eigen::Vector3d>& at, std::size_t most = most_places);

}  // namespace tapfit::updating
