// How many modes the residues of one pole hold: the rank, outputs x references,
// that stands out of their noise.
#pragma once

#include "modal/poles/frf_matrix.hpp"

#include <Eigen/Core>
#include <Eigen/SVD>

namespace tapfit::modal {

/// One value per FRF arranged as outputs x references.
[[nodiscard]] Eigen::MatrixXcd arranged(const FrfMatrix& matrix,
                                        const Eigen::VectorXcd& per_frf);

struct ResidueRank {
  Eigen::JacobiSVD<Eigen::MatrixXcd> svd;  ///< thin, of the arranged residues
  Eigen::Index rank = 0;  ///< singular values of modes, not of noise
};

/// Singular values of a matrix, outputs x references, that stand out of the
/// noise.
///
/// @param variance E|dR|^2 of each, n_frfs
[[nodiscard]] Eigen::Index rank_above_noise(const FrfMatrix& matrix,
                                            const Eigen::MatrixXcd& residues,
                                            const Eigen::VectorXd& variance);

/// The rank that is left whichever output is left out.
///
/// @param residue n_frfs
/// @param variance E|dR|^2 of each, n_frfs
[[nodiscard]] ResidueRank residue_rank(const FrfMatrix& matrix,
                                       const Eigen::VectorXcd& residue,
                                       const Eigen::VectorXd& variance);

/// Whether residues hold a second shape at all, noise or not: what is cheap to
/// know beforehand.
[[nodiscard]] bool holds_second_shape(const FrfMatrix& matrix,
                                      const Eigen::VectorXcd& residue);

}  // namespace tapfit::modal
