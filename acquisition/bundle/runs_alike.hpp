// Runs that measured the same FRFs: an analyser that writes a file for every
// hit, or a point that is hit again at the end.
#pragma once

#include "acquisition/bundle/test_bundle.hpp"

#include <cstddef>
#include <vector>

namespace tapfit::acquisition {

/// Indices into TestBundle::runs, ascending.
using RunGroup = std::vector<std::size_t>;

/// Every run once, with those of the same placement: the same hammer channel at
/// the same degree of freedom with its sign, and the same sensors' channels
/// likewise, in whatever order.
///
/// @return groups in the order of their first runs
[[nodiscard]] std::vector<RunGroup> runs_alike(const TestBundle& bundle);

/// Index of the group that a run is in.
[[nodiscard]] std::size_t group_of(const std::vector<RunGroup>& groups,
                                   std::size_t run);

/// The run with its sensors in the order of another one of its like.
[[nodiscard]] Run arranged_as(const Run& like, Run run);

}  // namespace tapfit::acquisition
