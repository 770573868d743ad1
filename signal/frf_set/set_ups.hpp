// Which FRFs belong to one state of the structure: the sensors load it, so
// runs are of one set-up as long as every sensor stays where it is.
#pragma once

#include "signal/frf_set/frf_set.hpp"

#include <cstddef>
#include <vector>

namespace tapfit::signal {

/// Set-up of each FRF, numbered from 0 in the order of first appearance.
///
/// Runs whose sensors sit at the same points are of one set-up; so is a run
/// that lacks some of another's FRFs but has no other point.
[[nodiscard]] std::vector<std::size_t> set_ups(const FrfSet& frfs);

}  // namespace tapfit::signal
