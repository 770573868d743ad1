// Checks that a pole fails or passes by itself, whatever the others are.
#pragma once

#include "modal/poles/identify_options.hpp"

#include <complex>

namespace tapfit::modal {

/// Whether no mode has this damping ratio.
[[nodiscard]] inline bool is_impossible(const std::complex<double>& pole,
                                        const IdentifyOptions& options) {
  const double zeta = -pole.real() / std::abs(pole);
  return zeta <= options.least_damping_ratio ||
         zeta > options.max_damping_ratio;
}

}  // namespace tapfit::modal
