// How well residues and shapes are known.
//
// Residues are linear in the FRFs for given poles, c = R^-1 Q' y, so that their
// covariance is R^-1 (Q' S Q) R^-T with S the noise of the lines. Shapes follow
// from the residues by P_ab = phi_a phi_b; dP = J dphi is solved by weighted
// least squares, and what the residues of one mode contradict each other widens
// the result.
#pragma once

#include "modal/fit/fit_noise.hpp"
#include "modal/fit/shapes.hpp"

#include <Eigen/Core>

namespace tapfit::modal {

/// E|dR|^2 of each residue of a fit, its poles taken as known.
///
/// @return n_frfs x n_modes
[[nodiscard]] Eigen::MatrixXd residue_variance(
    const WeightedFrfs& curves,
    const ModalFit& fit,
    NoiseFrom from = NoiseFrom::NearLines);

/// The same for noise that is known.
[[nodiscard]] Eigen::MatrixXd residue_variance(const WeightedFrfs& curves,
                                               const ModalFit& fit,
                                               const Noise& noise);

/// Standard deviation sqrt(E|dphi|^2) of each value of the shapes.
///
/// Unscaled shapes: of each value as a share of the largest, from the FRF that
/// knows it best.
///
/// @param residues n_frfs x n_modes, 0 where not found
/// @param variance of the residues, n_frfs x n_modes
/// @param shapes as mode_shapes gives them, n_dofs x n_modes
/// @return n_dofs x n_modes, in the unit of the shapes
[[nodiscard]] Eigen::MatrixXd shape_deviations(const ShapeGraph& graph,
                                               const Eigen::MatrixXcd& residues,
                                               const Eigen::MatrixXd& variance,
                                               const Eigen::VectorXcd& poles,
                                               const Eigen::MatrixXcd& shapes);

}  // namespace tapfit::modal
