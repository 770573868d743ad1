// How good each FRF is, in two numbers.
#pragma once

#include "signal/frf_set/frf_set.hpp"

#include <array>
#include <optional>
#include <vector>

namespace tapfit::signal {

struct FrfQuality {
  double mean_coherence = 0.0;  ///< over the band's lines, 0..1
  /// Median over the band's lines of sqrt(variance) / |H|, in percent.
  double median_sd_percent = 0.0;
};

/// One per FRF, in the set's order.
///
/// @param band_hz lower and upper frequency; empty: all lines. A band without
///   a line gives zeros.
[[nodiscard]] std::vector<FrfQuality> frf_quality(
    const FrfSet& set, const std::optional<std::array<double, 2>>& band_hz);

}  // namespace tapfit::signal
