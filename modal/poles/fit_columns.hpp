// The functions of s that a modal model of accelerance is a sum of.
#pragma once

#include <Eigen/Core>

namespace tapfit::modal {

/// Real parts over imaginary parts: 2 n x m.
[[nodiscard]] Eigen::MatrixXd stack(const Eigen::MatrixXcd& x);

/// The inverse of stack.
[[nodiscard]] Eigen::MatrixXcd unstack(const Eigen::MatrixXd& x);

/// Columns that multiply Re R and Im R of each mode in accelerance, g + h and
/// j (g - h) with
///
///   g = s^2 / (s - lambda)^p,  h = s^2 / (s - conj(lambda))^p
///
/// for p = 1, or their derivatives to the pole, p = 2.
///
/// @param s lines [rad/s]
/// @param poles [rad/s]
/// @return n_lines x 2 n_modes
[[nodiscard]] Eigen::MatrixXcd pole_columns(const Eigen::VectorXcd& s,
                                            const Eigen::VectorXcd& poles,
                                            int power);

/// Functions of s for modes out of the band: 1, s^2, s^4, 1/s^2, scaled to be
/// of size one; only the first two on fewer than 60 lines.
///
/// @return n_lines x n_terms
[[nodiscard]] Eigen::MatrixXcd residual_basis(const Eigen::VectorXcd& s,
                                              const Eigen::VectorXcd& band);

/// Re and Im of each residual term as columns: n_lines x 2 n_terms.
[[nodiscard]] Eigen::MatrixXcd term_columns(const Eigen::MatrixXcd& basis);

}  // namespace tapfit::modal
