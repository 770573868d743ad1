// Which poles of the stabilisation diagram belong to an identified mode.
#pragma once

#include "modal/mode_set/mode_set.hpp"
#include "modal/poles/stabilisation.hpp"

#include <complex>
#include <optional>
#include <vector>

namespace tapfit::modal {

/// The track whose pole is nearest to the one given, at most 1 % away; empty
/// where the diagram has none.
[[nodiscard]] std::optional<std::size_t> nearest_track(
    const std::vector<Track>& tracks, const std::complex<double>& pole);

/// Mean and standard deviation of a track's poles over the orders, from the
/// half of the orders in which it had settled.
[[nodiscard]] PoleCluster cluster_of(const Track& track);

}  // namespace tapfit::modal
