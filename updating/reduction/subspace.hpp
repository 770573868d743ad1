// Subspaces of a large model's motions, as columns of tall matrices.
#pragma once

#include "updating/structure/solve/bordered_matrix.hpp"

#include <Eigen/Core>

#include <vector>

namespace tapfit::updating {

/// Blocks side by side; shorter ones are zero below their last row.
[[nodiscard]] Eigen::MatrixXd join(std::vector<Eigen::MatrixXd> blocks);

/// Basis of the columns' span, orthonormal in M. Directions whose share of the
/// (normalised) columns is below `least` in the square are dropped.
[[nodiscard]] Eigen::MatrixXd orthonormalise(const structure::BorderedMatrix& M,
                                             Eigen::MatrixXd V,
                                             double least);

/// What of the columns lies outside the span of V (orthonormal in M), itself
/// orthonormal. V stays as it is: mixed with vectors that nearly repeat them,
/// modes would take up what little, but stiff, those have of their own.
///
/// @param V may be shorter than M: the rows that it lacks are zero
[[nodiscard]] Eigen::MatrixXd m_orthogonal_complement(
    const structure::BorderedMatrix& M,
    const Eigen::MatrixXd& V,
    Eigen::MatrixXd columns);

}  // namespace tapfit::updating
