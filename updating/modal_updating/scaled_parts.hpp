// A model as a sum of parts whose shares are unknown:
//
//   K(theta) = K0 + sum_j theta_j K_j,   M(theta) = M0 + sum_j theta_j M_j
//
// Where K0 is the nominal model, theta_j is the relative change of a part.
#pragma once

#include "updating/structure/solve/system.hpp"

#include <Eigen/Core>

#include <string>
#include <vector>

namespace tapfit::updating {

struct ScaledPart {
  std::string name;             ///< as in messages and results
  structure::SparseMatrix K;    ///< n x n, or 0 x 0 where it does not enter
  structure::SparseMatrix M{};  ///< likewise
};

struct ScaledModel {
  structure::SparseMatrix K0;  ///< n x n, over the free degrees of freedom
  structure::SparseMatrix M0;
  std::vector<ScaledPart> parts;

  /// @param theta one per part
  [[nodiscard]] structure::SparseMatrix stiffness(
      const Eigen::VectorXd& theta) const;
  [[nodiscard]] structure::SparseMatrix mass(
      const Eigen::VectorXd& theta) const;
};

/// @throws InputError naming the matrix whose size is not that of K0, that is
///   not symmetric or not finite, and the part that has neither K nor M
void check(const ScaledModel& model);

}  // namespace tapfit::updating
