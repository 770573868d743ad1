// The Gauss-Newton step of the poles, the residues being eliminated (variable
// projection). E holds the derivatives of the columns to each pole's real and
// imaginary part for unit Re R and Im R, e = E - Phi (Phi' Phi)^-1 Phi' E what
// the columns cannot follow of them. With C_f putting the residues of FRF f,
//
//   N = sum_f C_f' (e' e) C_f,   g = sum_f C_f' e' r_f
//
// r_f what the linear fit leaves; e' r_f = e' y_f.
//
// Source: L. Kaufman, "A variable projection method for solving separable
// nonlinear least squares problems", BIT 15, 1975, p. 49-57; G. Golub,
// V. Pereyra, "Separable nonlinear least squares", Inverse Problems 19, 2003.
#pragma once

#include "modal/fit/linear_fit.hpp"

#include <Eigen/Core>

namespace tapfit::modal {

struct PoleStep {
  Eigen::MatrixXd normal;    ///< N, 2 n_modes square: Re and Im by turns
  Eigen::VectorXd gradient;  ///< g, 2 n_modes: of minus half the misfit
};

[[nodiscard]] PoleStep pole_step(const WeightedFrfs& curves,
                                 const Eigen::VectorXcd& poles,
                                 const LinearFit& linear);

/// e on all lines, 2 n_lines x 2 n_modes.
[[nodiscard]] Eigen::MatrixXd projected_derivatives(
    const WeightedFrfs& curves,
    const Eigen::VectorXcd& poles,
    const LinearFit& linear);

/// Solves (N + mu diag N) x = g in units of the diagonal.
[[nodiscard]] Eigen::VectorXd damped_solve(const PoleStep& step, double mu);

/// sum_f w_f^2 C_f' G C_f for any G in place of e' e.
///
/// @param weight w of each FRF and mode: n_frfs x n_modes
[[nodiscard]] Eigen::MatrixXd with_residues(const Eigen::MatrixXd& G,
                                            const LinearFit& linear,
                                            const Eigen::MatrixXd& weight);

}  // namespace tapfit::modal
