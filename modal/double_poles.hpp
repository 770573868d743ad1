// Several modes under one pole. The residues of a mode are of rank one, outputs
// x references, so that those of one pole in the place of n are of rank n:
// that, and not the misfit, tells of modes much closer than their bandwidths.
// Around the one pole lambda_0
//
//   sum_k R_k / (s - lambda_k) ~ M / (s - lambda_0) + D / (s - lambda_0)^2,
//   M = sum_k R_k,  D = sum_k (lambda_k - lambda_0) R_k
//
// and in the n singular directions M = U S V' above the noise, the eigenvalues
// of U' D V S^-1 are the lambda_k - lambda_0.
#pragma once

#include "modal/frf_matrix.hpp"
#include "modal/modal_fit.hpp"

#include <Eigen/Core>

namespace tapfit::modal {

/// The poles in place of pole r of a fit: as many as the rank of its residues,
/// beyond their noise, tells of; a single one is pole r itself.
///
/// At most as many as there are references. The expansion holds while the
/// poles are within about a half bandwidth of each other.
[[nodiscard]] Eigen::VectorXcd poles_in_place_of(const Curves& curves,
                                                 const FrfMatrix& matrix,
                                                 const ModalFit& fit,
                                                 Eigen::Index r);

}  // namespace tapfit::modal
