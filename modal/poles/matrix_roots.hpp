// Roots of the determinant of a real matrix polynomial, by simultaneous
// iteration (Ehrlich and Aberth).
//
//   A(z) = I z^n + A_{n-1} z^{n-1} + ... + A_0
//   z_i <- z_i - 1 / (tr(A^-1 A')(z_i) - sum_{j != i} 1 / (z_i - z_j))
//
// All roots at once cost O((n k)^2) per sweep where the QR iteration on the
// companion matrix costs O((n k)^3), and the roots of a polynomial of almost
// the same degree are a good start. Outside the unit circle the reversed
// polynomial is evaluated, so that no power overflows.
//
// Source: D. A. Bini, V. Noferini, "Solving polynomial eigenvalue problems by
// means of the Ehrlich-Aberth method", Linear Algebra and its Applications 439,
// 2013, p. 1130-1149.
#pragma once

#include <Eigen/Core>

namespace tapfit::modal {

/// The n k roots of det A, in no order.
///
/// Where the iteration does not settle (many roots that coincide) the
/// eigenvalues of the companion matrix are returned instead.
///
/// @param A coefficients side by side, A_0 first, without the highest, which is
///   the identity: k x (n k), finite
/// @param start guesses for some of the roots, as many as wanted
/// @return n k roots; empty when neither way gives any
[[nodiscard]] Eigen::VectorXcd matrix_roots(const Eigen::MatrixXd& A,
                                            const Eigen::VectorXcd& start);

/// Unit vector v with A(z)' v = 0 at a root z: nearly so at an inexact one.
[[nodiscard]] Eigen::VectorXcd left_null_vector(const Eigen::MatrixXd& A,
                                                std::complex<double> z);

}  // namespace tapfit::modal
