// The least of a quadratic within bounds, by an active set:
//
//   min over lower <= d <= upper of  1/2 d'Ad + g'd
//
// A step that is cut off at the bounds afterwards may lead uphill; this one
// does not.
//
// Source: P. B. Stark, R. L. Parker, "Bounded-variable least-squares",
// Computational Statistics 10, 1995, p. 129-141.
#pragma once

#include <Eigen/Core>

namespace tapfit::updating {

/// @param A n x n, symmetric and positive definite
/// @param lower, upper of d, with lower <= 0 <= upper; may be infinite
/// @return n; never worse than d = 0
[[nodiscard]] Eigen::VectorXd bounded_step(const Eigen::MatrixXd& A,
                                           const Eigen::VectorXd& g,
                                           const Eigen::VectorXd& lower,
                                           const Eigen::VectorXd& upper);

}  // namespace tapfit::updating
