// How a mode's eigenvalue and shape change with the shares of a model's parts:
//
//   d lambda_i = phi_i' (dK - lambda_i dM) phi_i
//   d phi_i    = -1/2 (phi_i' dM phi_i) phi_i
//                + sum_k phi_k (phi_k' f) / (lambda_i - lambda_k) + x,
//   f = (dK - lambda_i dM) phi_i,   (K - lambda_i M) x = -f,  x' M phi_k = 0
//
// The sum runs over the other modes that are known. x is what all modes above
// would add to it: there K - lambda_i M is positive definite, so that x comes
// from conjugate gradients, preconditioned by one factorisation of K + s M that
// serves all modes and parts. Nothing is cut off, unlike in the sum alone.
//
// Source: R. L. Fox, M. P. Kapoor, "Rates of change of eigenvalues and
// eigenvectors", AIAA Journal 6(12), 1968, p. 2426-2429; with x it is the
// derivative of R. B. Nelson, AIAA Journal 14(9), 1976, p. 1201-1205.
#pragma once

#include "updating/modal_updating/scaled_parts.hpp"
#include "updating/structure/solve/eigenmodes.hpp"
#include "updating/structure/solve/factor.hpp"

namespace tapfit::updating {

struct ModeDerivative {
  Eigen::RowVectorXd lambda;  ///< by each theta, lambda = omega^2 [rad^2/s^2]
  Eigen::MatrixXd phi;        ///< n x parts
};

class ModeSensitivity {
 public:
  /// @param model must outlive this
  /// @param modes at theta, every one from the lowest up; the last has to be
  ///   above the modes that will be asked for, or the n-th
  /// @throws InputError where K + s M cannot be factored
  ModeSensitivity(const ScaledModel& model,
                  const Eigen::VectorXd& theta,
                  structure::Eigenmodes modes);

  /// Two modes of one frequency (to 1e-8 of lambda) may turn in their plane;
  /// that turn has no derivative and is left out.
  ///
  /// @param mode its column in the modes given
  [[nodiscard]] ModeDerivative of(Eigen::Index mode) const;

 private:
  [[nodiscard]] Eigen::MatrixXd from_above(const Eigen::MatrixXd& F,
                                           double lambda) const;

  const ScaledModel& model_;
  structure::Eigenmodes modes_;
  Eigen::VectorXd lambda_;
  structure::SparseMatrix K_;
  structure::SparseMatrix M_;
  Eigen::MatrixXd MPhi_;
  structure::Factor shifted_;
};

}  // namespace tapfit::updating
