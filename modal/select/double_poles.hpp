// Several modes under one pole. The residues of a mode are of rank one, outputs
// x references, so that those of one pole in the place of n are of rank n:
// that, and not the misfit, tells of modes much closer than their bandwidths.
// Around the one pole lambda_0
//
//   sum_k R_k / (s - lambda_k) ~ M / (s - lambda_0) + D / (s - lambda_0)^2,
//   M = sum_k R_k,  D = sum_k (lambda_k - lambda_0) R_k
//
// and in the n singular directions M = U S V' above the noise, the eigenvalues
// of K = U' D V S^-1 are the lambda_k - lambda_0 and U times its eigenvectors
// the shapes of the modes.
#pragma once

#include "modal/fit/modal_fit.hpp"
#include "modal/fit/residue_rank.hpp"
#include "modal/poles/frf_matrix.hpp"

#include <Eigen/Core>

namespace tapfit::modal {

struct PoleExpansion {
  ResidueRank residues;      ///< of M: as many modes as its rank
  Eigen::VectorXcd apart;    ///< lambda_k - lambda_0 [rad/s], n_modes
  Eigen::MatrixXcd vectors;  ///< eigenvectors of K, n_modes square
  double deviation = 0.0;    ///< of K, over all of it [rad/s]
};

/// A fit with M and D for pole r: two poles, in its place and the last, at a
/// small distance from it on the real axis.
[[nodiscard]] ModalFit expanded_fit(const WeightedFrfs& curves,
                                    const ModalFit& fit,
                                    Eigen::Index r);

/// Expands what a fit has in pole r.
///
/// The expansion holds while the poles are within about a half bandwidth of
/// each other. There are at most as many as references.
///
/// @return no more than the rank, where that is one
[[nodiscard]] PoleExpansion expand_pole(const WeightedFrfs& curves,
                                        const FrfMatrix& matrix,
                                        const ModalFit& fit,
                                        Eigen::Index r);

}  // namespace tapfit::modal
