// Identifies parameters from FRFs: the minimum
// (updating/minimiser/minimise.hpp) of
//
//   J(theta) = N ln ||r(theta)||^2 + sum ((theta - mean) / sd)^2
//
// with N of residual/independent_data.hpp, of the residual it starts from, and
// whose Gauss-Newton step is eq. 27 of the paper with the Tikhonov matrix of
// the prior, lambda^2 = (||r||^2 / N) diag(1 / sd^2). theta are logarithms, so
// that masses stay positive.
#pragma once

#include "acquisition/foundation/progress.hpp"
#include "updating/fit/update_history.hpp"
#include "updating/frf_model/frf_model.hpp"
#include "updating/minimiser/minimise.hpp"
#include "updating/residual/l_curve.hpp"
#include "updating/residual/residual.hpp"

#include <Eigen/Core>

#include <optional>
#include <string>
#include <vector>

namespace tapfit::updating {

struct UpdateResult {
  ModelState state;
  double error = 0.0;          ///< ||r||
  double objective = 0.0;      ///< J
  Eigen::MatrixXd covariance;  ///< of theta
  Eigen::MatrixXd jacobian;    ///< d r / d theta at the end
  Eigen::VectorXd residual;
  double prior_cost = 0.0;  ///< what J has beside the data's
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
                                  const MinimiseOptions& options,
                                  const Progress& progress = {});

}  // namespace tapfit::updating
