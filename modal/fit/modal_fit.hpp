// The room modal/fit. The modal model fitted to FRFs for given poles, and how
// well it is known.
// In:  Weighted FRFs and poles.
// Out: Residues, refined poles and their covariance, shapes, FRFs beyond what
//      was measured.
// May include: its row in CONTRIBUTING.md.
//
// The modal model fitted to FRFs: residues by linear least squares, poles by
// Gauss-Newton on what the residues leave (variable projection).
//
//   H_f(s) = s^2 sum_r [ R_fr / (s - lambda_r) + conj(R_fr) / (s -
//            conj(lambda_r)) ] + a_f + b_f s^2 + c_f s^4 + d_f / s^2
//
// The last terms stand for the modes below the band (a mass line and its first
// correction) and above it (a compliance and its first correction).
// Lines are weighted alike in all FRFs, w_f(k) = u_f v(k), so that one matrix
// of products of the columns serves all of them; a step's cost hardly depends
// on the number of lines (column_products.hpp).
//
// Source: G. Golub, V. Pereyra, "Separable nonlinear least squares", Inverse
// Problems 19, 2003, R1-R26, with Kaufman's simplified Jacobian.
#pragma once

#include "modal/fit/modal_model.hpp"
#include "modal/poles/weighted_frfs.hpp"

#include <Eigen/Core>

namespace tapfit::modal {

/// Residues for given poles. No two poles may coincide.
[[nodiscard]] ModalFit fit_residues(const WeightedFrfs& curves,
                                    const Eigen::VectorXcd& poles);

/// Poles and residues together, starting from given poles.
///
/// @param iterations most Gauss-Newton steps; ends early when poles rest
[[nodiscard]] ModalFit refine_poles(const WeightedFrfs& curves,
                                    const Eigen::VectorXcd& start,
                                    int iterations);

/// What the fitted H leave of the FRFs, over these: in the norm that the fit
/// makes least, each value weighed by its line and FRF.
///
/// @param H n_lines x n_frfs
[[nodiscard]] double relative_misfit(const WeightedFrfs& curves,
                                     const Eigen::MatrixXcd& H);

}  // namespace tapfit::modal
