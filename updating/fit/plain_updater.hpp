// The paper's updating of model parameters, as printed:
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

#include "updating/frf_model/frf_model.hpp"
#include "updating/residual/identifiability.hpp"
#include "updating/residual/l_curve.hpp"
#include "updating/residual/line_choice.hpp"
#include "updating/residual/residual.hpp"

#include <Eigen/Core>

#include <optional>
#include <string>
#include <vector>

namespace tapfit::updating {

struct PlainOptions {
  int max_iterations = 20;
  double tolerance = 1e-6;       ///< on ||P_(n+1) - P_n||, P over its nominal
  std::optional<double> lambda;  ///< empty: the L-curve's corner at each step
  /// So many of the first properties are updated; empty: all.
  std::optional<std::size_t> properties;
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
  /// iterations + 1 x P: properties over nominal, effects over their start
  Eigen::MatrixXd history;
  std::vector<Eigen::Index> packed;  ///< where each of P is in pack()
  Eigen::VectorXd misfit;            ///< ||delta|| at each of them
  std::vector<double> lambda;        ///< of each step
  LCurve l_curve;                    ///< of the last step
  LCurve first_l_curve;   ///< of the first, where there is most to explain
  std::vector<bool> use;  ///< which lines counted at the end
  Identifiability identifiability;  ///< at the end
};

/// @param start its factors and the sizes of its effects are updated; its
///   damping is taken as given
/// @param target measured accelerances, with their variance where `by_scatter`
[[nodiscard]] PlainResult plain_update(const FrfModel& model,
                                       const Target& target,
                                       const ModelState& start,
                                       const PlainOptions& options);

}  // namespace tapfit::updating
