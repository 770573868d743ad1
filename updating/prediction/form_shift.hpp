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
//
// Of a support that is let go b holds what held it, which was rigid and is no
// part of the form. What the deck itself is strained by is then in the
// stiffness after the change, K_c, known but for the support's small part:
//
//   cov = tau^2 / 4 (phi_b' K_c phi_c)^2 / (omega_b^2 omega_c^2)
//       = tau^2 / 4 (omega_c phi_b' M_c phi_c / omega_b)^2.
#pragma once

#include <Eigen/Core>

namespace tapfit::updating {

/// Of ln f, in units of tau^2 / 4.
struct FormShift {
  double now = 1.0;    ///< variance before the change
  double after = 1.0;  ///< after it
  double both = 1.0;   ///< their covariance
};

/// A mode after the change, of unit mass with it.
struct ModeAfter {
  Eigen::VectorXd u;    ///< in the modes before, r
  double omega = 0.0;   ///< above zero [rad/s]
  double of_now = 0.0;  ///< phi_b' M_c phi_c: what the mode before has of it
};

/// @param omega of the modes before the change [rad/s], r
/// @param mode which of them
[[nodiscard]] FormShift form_shift(const Eigen::VectorXd& omega,
                                   const ModeAfter& after,
                                   Eigen::Index mode);

}  // namespace tapfit::updating
