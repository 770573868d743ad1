// A run whose file states another sampling rate than it was sampled at. All its
// frequencies are those of the other runs times one ratio, damping ratios and
// the size of accelerances stay:
//
//   H'(s) = H(s / ratio)
//
// Instruments sample at a few rates and their halves; two of them make the
// ratio. Where a structure is in another state, hardly any mode moves as the
// next one does, and not by such a ratio.
#pragma once

#include "signal/frf_set/frf_set.hpp"

#include <Eigen/Core>

#include <optional>
#include <vector>

namespace tapfit::modal {

struct RunRateLimits {
  /// That the ratio must explain: of fewer some ratio explains any.
  Eigen::Index fewest_modes = 3;
  /// What the ratio may leave of the run against what is left as it is.
  double explained = 0.25;
  /// Of what any ratio leaves that is further away than `beside`.
  double alone = 0.5;
  double beside = 0.05;  ///< of its logarithm
  /// Of the run's lines that the others' band must reach.
  double share_of_lines = 0.45;
  /// Times what the poles leave of the other runs that it may leave, beside two
  /// per cent.
  double times_usual = 3.0;
};

/// Ratios of two rates, between a half and two, 1 left out; ascending.
[[nodiscard]] std::vector<double> rate_ratios();

/// The ratio that explains a run's FRFs by the others' poles.
/// @param run FRFs of one run
/// @param poles [rad/s] that the other runs show, Im > 0
/// @param usual what these leave of the other runs, relative
/// @return none where none does
[[nodiscard]] std::optional<double> rate_ratio(
    const signal::FrfSet& run,
    const Eigen::VectorXcd& poles,
    double usual,
    const RunRateLimits& limits = {});

}  // namespace tapfit::modal
