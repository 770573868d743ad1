// The modal assurance criterion and its family.
//
//   MAC(u, v) = |u^H v|^2 / ((u^H u) (v^H v))
//
// Source: eq. 33 of the updating paper, with the conjugate for complex shapes;
// R. J. Allemang, "The modal assurance criterion", Sound and Vibration, 2003.
#pragma once

#include <Eigen/Core>

namespace tapfit::modal {

/// MAC of every column of U with every column of V; 0 for a zero column.
///
/// @param U n_dof x p shapes
/// @param V n_dof x q shapes
/// @return p x q, each entry 0..1
[[nodiscard]] Eigen::MatrixXd mac(const Eigen::MatrixXcd& U,
                                  const Eigen::MatrixXcd& V);

/// Coordinate MAC of paired shapes: how well each degree of freedom agrees
/// over all pairs.
///
/// @param U, V n_dof x p; column k of one belongs to column k of the other
/// @return n_dof values, each 0..1
[[nodiscard]] Eigen::VectorXd comac(const Eigen::MatrixXcd& U,
                                    const Eigen::MatrixXcd& V);

}  // namespace tapfit::modal
