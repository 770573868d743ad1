// The reduced normal equations of pLSCF without forming what they are of.
//
//   M = sum_o (T_o - S_o' R^-1 S_o)
//
// R (Toeplitz) and the weights are common to all outputs; S_o and T_o are block
// Toeplitz. Then M is close to block Toeplitz too: with x = R^-1 e_0 and
// s_j the block column j of S_o,
//
//   M[i+1, j+1] - M[i, j] = -(p_{i+1}' p_{j+1} - q_i' q_j) / x_0,
//   p_j = x' s_j,  q_j = (J x)' s_j,  J the reversal
//
// (Gohberg and Semencul's formula for R^-1, summed over the outputs), so that
// its first row and two small products give all of it: O(n^2) per output
// instead of O(n^3).
//
// Source: T. Kailath, A. H. Sayed, "Displacement structure: theory and
// applications", SIAM Review 37(3), 1995, p. 297-386.
#pragma once

#include "modal/poles/band_circle.hpp"
#include "modal/poles/frf_matrix.hpp"

#include <Eigen/Core>

namespace tapfit::modal {

/// M for the largest degree; its leading blocks are those of the lower degrees
/// with as many numerator terms.
///
/// @param largest degree of numerators and denominator, n
/// @return (n + 1) n_references square, symmetric
[[nodiscard]] Eigen::MatrixXd reduced_normal(const WeightedFrfs& curves,
                                             const FrfMatrix& matrix,
                                             const BandCircle& circle,
                                             Eigen::Index largest);

}  // namespace tapfit::modal
