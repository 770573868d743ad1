// The room updating/minimiser. Parameters that make a misfit least.
// In:  residuals and their derivatives as a function of parameters; a prior.
// Out: the parameters at the minimum, and how it was reached.
// May include: its row in CONTRIBUTING.md.
//
// The minimum, within bounds, of a misfit whose scale is not known:
//
//   f(theta) = N ln ||r(theta)||^2 + sum ((theta - mean) / sd)^2 +
//   ||k(theta)||^2
//
// k is what is known besides, in its deviations: a mass that was weighed.
//
// The residual's variance (real data never reach the noise floor) is integrated
// out, hence the logarithm. Each step is the least, in a box around the last
// point, of a quadratic with half the gradient and half the curvature
//
//   g = w J'r + P (theta - mean) + K'k,  A = w (J'J + S) + P + K'K,
//   w = N / ||r||^2,  P = diag(1 / sd^2),  K = dk / dtheta
//
// S is what J'J lacks, sum r_i d2 r_i / d theta^2, told by how J changed from
// step to step. Where much is left, as before an effect is found, steps by J'J
// alone go past the minimum and back; S is used where it foretold the last step
// better.
// Source: J. E. Dennis, D. M. Gay, R. E. Welsch, "An adaptive nonlinear
// least-squares algorithm", ACM Transactions on Mathematical Software 7, 1981,
// p. 348 (S and its sizing); A. R. Conn, N. I. M. Gould, P. L. Toint, "Trust
// Region Methods", 2000, ch. 6 (the box).
#pragma once

#include <Eigen/Core>

#include <functional>
#include <optional>
#include <string>

namespace tapfit::updating {

struct Residuals {
  Eigen::VectorXd r;
  Eigen::MatrixXd J;  ///< d r / d theta, rows of r x parameters
};

/// What is known of theta beforehand; sd infinite where nothing is.
struct Prior {
  Eigen::VectorXd mean;
  Eigen::VectorXd sd;
  Eigen::VectorXd lower;  ///< hard bounds
  Eigen::VectorXd upper;
  /// Of other data k(theta), in their standard deviations; empty: there are
  /// none.
  std::function<Residuals(const Eigen::VectorXd& theta)> known = {};
};

/// All of it as rows of a residual: squares sum to the prior's cost, one row a
/// parameter first, zero where nothing is known of it.
[[nodiscard]] Residuals prior_residuals(const Prior& prior,
                                        const Eigen::VectorXd& theta);

/// d k / d theta of the other data; 0 x 0 where there are none.
[[nodiscard]] Eigen::MatrixXd known_slopes(const Prior& prior,
                                           const Eigen::VectorXd& theta);

/// Empty where there are none, as of a model without an answer.
using Evaluate =
    std::function<std::optional<Residuals>(const Eigen::VectorXd& theta)>;

/// Where the minimiser is.
struct Iterate {
  Eigen::VectorXd theta;
  Residuals at;
  double prior_cost = 0.0;  ///< what f has beside the data's
  double objective = 0.0;   ///< f
  double moved = 0.0;       ///< largest change of a parameter on the way here
};

/// Told of the start and of every step that lowers f, right after its
/// evaluation; false: end here.
using OnStep = std::function<bool(const Iterate& point)>;

struct MinimiseOptions {
  int most_steps = 30;
  double tolerance = 1e-6;  ///< on the largest change of a parameter
  /// On the decrease of f that a step promises; d standard errors away from
  /// its minimum f is d^2 above it.
  double objective_tolerance = 0.0;
};

struct Minimum {
  Iterate point;
  double data = 0.0;  ///< N
  bool converged = false;
  std::string message;  ///< why it ended
};

/// Independent data in a residual, N: told once, of the residual at the start,
/// so that what is made least stays the same all the way.
using CountData = std::function<double(const Eigen::VectorXd& r)>;

/// @param start is moved into the bounds
/// @return never a point with a larger f than the start's; empty where there
///   are no residuals at the start
[[nodiscard]] std::optional<Minimum> minimise(const Evaluate& evaluate,
                                              const Prior& prior,
                                              const CountData& data,
                                              const Eigen::VectorXd& start,
                                              const MinimiseOptions& options,
                                              const OnStep& on_step = {});

}  // namespace tapfit::updating
