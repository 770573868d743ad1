// Modes after a known change. With theta what was fitted (ln), C its
// covariance, and slopes by central differences of the model's frequencies,
//
//   g_n = d ln f_now / d theta,  g_a = d ln f_after / d theta
//
// and V, W, U the variances of ln f_now and ln f_after and their covariance by
// the deck's form (form_shift.hpp), the model's own prediction has
//
//   A = var ln f_after = g_a' C g_a + W,   N = var ln f_now = g_n' C g_n + V,
//   B = cov = g_n' C g_a + U,   var ln (f_after / f_now) = A + N - 2 B.
//
// Where the mode was measured, f_m with deviation sd_m, what the model is off
// by now tells what it will be off by (best linear estimate, of normal errors
// the conditional one):
//
//   ln f = ln f_after + g (ln f_m - ln f_now),  g = B / (N + (sd_m / f_m)^2),
//   var ln f = A - g B.
//
// Parameters and form are taken as independent, though the first may have been
// driven by the second: wider rather than narrower. Source of the estimate: A.
// Gelman et al., "Bayesian Data Analysis", 3rd ed., 2013, sec. 14.2.
#pragma once

#include "updating/comparison/comparison.hpp"
#include "updating/prediction/changed_model.hpp"
#include "updating/prediction/prediction.hpp"

#include <vector>

namespace tapfit::updating {

/// What is known before the change.
struct KnownNow {
  const modal::ModeSet& measured;
  const std::vector<ModePair>& pairs;  ///< measured, and the model's modes
  Eigen::MatrixXd covariance;          ///< of theta, see parameter_spread()
  double form_variance = 0.0;          ///< tau^2 / 4, of ln f
  std::vector<std::size_t> runs;       ///< that were measured
};

/// Those in the band before or after, and those that were measured.
[[nodiscard]] std::vector<PredictedMode> predicted_modes(
    const ChangedModel& model, const KnownNow& known);

/// Frequencies in the band that no mode before the change becomes: what it
/// brings on springs of its own [Hz].
[[nodiscard]] std::vector<double> new_frequencies(const ChangedModel& model);

}  // namespace tapfit::updating
