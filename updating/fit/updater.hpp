// Identifies parameters from FRFs: Levenberg-Marquardt on
//
//   J(theta) = N ln ||r(theta)||^2 + sum ((theta - mean) / sd)^2
//
// whose Gauss-Newton step is eq. 27 of the paper with the Tikhonov matrix of
// the prior, lambda^2 = (||r||^2 / N) diag(1 / sd^2). The residual's variance
// is unknown (real data never reach the noise floor) and integrated out, hence
// the logarithm. theta are logarithms, so that masses stay positive.
#pragma once

#include "acquisition/foundation/progress.hpp"
#include "updating/fit/l_curve.hpp"
#include "updating/fit/residual.hpp"
#include "updating/fit/update_history.hpp"
#include "updating/frf_model/frf_model.hpp"

#include <Eigen/Core>

#include <optional>
#include <string>
#include <vector>

namespace tapfit::updating {

/// What is known of theta beforehand; sd infinite where nothing is.
struct Prior {
  Eigen::VectorXd mean;
  Eigen::VectorXd sd;
  Eigen::VectorXd lower;  ///< hard bounds
  Eigen::VectorXd upper;
};

/// 1 / sd^2, zero where there is no prior.
[[nodiscard]] Eigen::VectorXd precision(const Prior& prior);

struct UpdateOptions {
  int max_iterations = 30;
  double tolerance = 1e-6;  ///< on the relative change of the parameters
  /// On the decrease of J in one step; d standard errors away from its minimum
  /// J is d^2 above it.
  double objective_tolerance = 0.0;
};

struct UpdateResult {
  ModelState state;
  double error = 0.0;          ///< ||r||
  double objective = 0.0;      ///< J
  Eigen::MatrixXd covariance;  ///< of theta
  Eigen::MatrixXd jacobian;    ///< d r / d theta at the end
  Eigen::VectorXd residual;
  double prior_cost = 0.0;  ///< sum ((theta - mean) / sd)^2
  /// The start, then each step; see update_history.hpp.
  std::vector<UpdateStep> history;
  bool converged = false;
  std::string message;                 ///< why it stopped
  std::optional<LCurve> l_curve = {};  ///< where lambda was a choice
  Prior prior = {};                    ///< where it was not
  double lambda = 0.0;                 ///< the prior's at the end, see above
};

/// Never returns a state with a larger J than the one given.
[[nodiscard]] UpdateResult update(const FrfModel& model,
                                  const Target& target,
                                  const ModelState& start,
                                  const Prior& prior,
                                  const UpdateOptions& options,
                                  const Progress& progress = {});

}  // namespace tapfit::updating
