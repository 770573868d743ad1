// Which parameters the data can tell apart: singular values of the
// sensitivities with columns of unit length, and correlations. A direction
// with next to no singular value is a change of several parameters that leaves
// every FRF as it is. Source: J. E. Mottershead, M. Link, M. I. Friswell, "The
// sensitivity method in finite element model updating: a tutorial", MSSP 25,
// 2011, p. 2275-2296, section 5.
#pragma once

#include <Eigen/Core>

#include <vector>

namespace tapfit::updating {

struct Identifiability {
  Eigen::VectorXd singular_values;  ///< descending, of the scaled columns
  Eigen::MatrixXd directions;       ///< columns, in parameters as given
  Eigen::MatrixXd correlation;      ///< of the estimates, ones on the diagonal
  /// Positions of parameters that cannot be told apart; of one alone: it does
  /// not show in the data at all.
  std::vector<std::vector<Eigen::Index>> confounded;
};

/// @param S m x n sensitivities, m >= n
/// @param least singular value over the largest below which a direction is
///   taken for nothing
[[nodiscard]] Identifiability identifiability(const Eigen::MatrixXd& S,
                                              double least = 1e-3);

}  // namespace tapfit::updating
