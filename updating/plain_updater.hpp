// The paper's updating of model properties, as printed:
//
//   P_(n+1) = P_n + (S'S + lambda^2 I)^-1 S' delta     (eq. 27)
//   delta   = H_measured - H(P_n), receptances         (eq. 18)
//
// with lambda from the L-curve and lines chosen by the rule of section 2.3. No
// step is refused, so that it may diverge where lines lie at resonances; that
// is what update() with its damped lines is for.
// Source: "Model Updating Using Frequency Response Functions Based on
// Sherman-Morrison Formula", equations 17 to 27.
#pragma once

#include "updating/frf_model.hpp"
#include "updating/identifiability.hpp"
#include "updating/l_curve.hpp"
#include "updating/line_choice.hpp"
#include "updating/residual.hpp"

#include <Eigen/Core>

#include <optional>
#include <string>

namespace tapfit::updating {

struct PlainOptions {
  int max_iterations = 20;
  double tolerance = 1e-6;       ///< on ||P_(n+1) - P_n||, P over its nominal
  std::optional<double> lambda;  ///< empty: the L-curve's corner at each step
  /// Each datum in units of its standard deviation (Target::variance) instead
  /// of all alike.
  bool by_scatter = false;
  /// Lines are chosen anew in each iteration; empty: all.
  std::optional<PeakRule> rule;
  Eigen::VectorXd measured_hz;  ///< resonances, for the rule
};

struct PlainResult {
  ModelState state;
  bool converged = false;
  std::string message;
  Eigen::MatrixXd history;  ///< iterations + 1 x properties, P over nominal
  Eigen::VectorXd misfit;   ///< ||delta|| at each of them
  LCurve l_curve;           ///< of the last step
  Identifiability identifiability;  ///< at the end
};

/// @param start its factors are updated, nothing else
/// @param target measured accelerances, with their variance where `by_scatter`
[[nodiscard]] PlainResult plain_update(const FrfModel& model,
                                       const Target& target,
                                       const ModelState& start,
                                       const PlainOptions& options);

}  // namespace tapfit::updating
