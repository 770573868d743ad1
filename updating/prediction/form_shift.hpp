// How a deck that is wrong in form shifts a mode's frequency before and after a
// change. With the modal stiffness off by omega_i omega_j e_ij, e symmetric and
// random, of variance tau^2 on the diagonal and tau^2 / 2 beside it (as in
// FrfModel::form_patterns()), a mode that is sum_i u_i phi_i of the modes
// before the change is off to first order by
//
//   d ln f = b' e b / (2 omega^2),   b_i = omega_i u_i,
//
// and of two modes, since E(b' e b)(c' e c) = tau^2 (b' c)^2,
//
//   cov = tau^2 / 4 (b' c)^2 / (omega_b^2 omega_c^2).
//
// A mass leaves the strains of a mode much as they were: form shifts it by the
// same share before and after, and says little of the change.
#pragma once

#include <Eigen/Core>

namespace tapfit::updating {

/// Of ln f, in units of tau^2 / 4.
struct FormShift {
  double now = 1.0;    ///< variance before the change
  double after = 1.0;  ///< after it
  double both = 1.0;   ///< their covariance
};

/// @param omega of the modes before the change [rad/s], r
/// @param mode which of them
/// @param u the mode after the change in those before, r; of unit mass with the
///   change
/// @param omega_after its own, above zero [rad/s]
[[nodiscard]] FormShift form_shift(const Eigen::VectorXd& omega,
                                   Eigen::Index mode,
                                   const Eigen::VectorXd& u,
                                   double omega_after);

}  // namespace tapfit::updating
