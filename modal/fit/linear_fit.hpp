// Residues and residual terms for given poles: linear least squares, by the
// normal equations of columns of unit length,
//
//   S^-1 Phi' Phi S^-1 (S c) = S^-1 Phi' y,   L L' = S^-1 Phi' Phi S^-1
//
// whose products need no pass over the lines (column_products.hpp).
#pragma once

#include "modal/fit/column_products.hpp"
#include "modal/fit/modal_model.hpp"
#include "modal/poles/curves.hpp"

#include <Eigen/Cholesky>
#include <Eigen/Core>

namespace tapfit::modal {

struct LinearFit {
  PoleSums sums;
  Eigen::VectorXd scale;                ///< S: length of each column
  Eigen::LLT<Eigen::MatrixXd> factor;   ///< L
  Eigen::MatrixXd whitened;             ///< L^-1 S^-1 Phi' y, n_columns x n_frfs
  Eigen::MatrixXd coefficients;         ///< c of u H, n_columns x n_frfs
  double misfit = 0.0;                  ///< weighted squares that are left
};

/// @param poles [rad/s]; columns that all but coincide share what they explain
[[nodiscard]] LinearFit fit_linear(const Curves& curves,
                                   const Eigen::VectorXcd& poles);

/// L^-1 S^-1 x.
[[nodiscard]] Eigen::MatrixXd whitened(const LinearFit& linear,
                                       const Eigen::MatrixXd& x);

/// (Phi' Phi)^-1 x.
[[nodiscard]] Eigen::MatrixXd normal_solve(const LinearFit& linear,
                                           const Eigen::MatrixXd& x);

/// Phi on some lines, weighted by v: real over imaginary parts,
/// 2 count x n_columns.
[[nodiscard]] Eigen::MatrixXd model_columns(const Curves& curves,
                                            const Eigen::VectorXcd& poles,
                                            Eigen::Index begin,
                                            Eigen::Index count);

/// The fitted accelerances, n_lines x n_frfs.
[[nodiscard]] Eigen::MatrixXcd fitted_accelerance(const Curves& curves,
                                                  const ModalFit& fit);

/// On some lines only: count x n_frfs.
[[nodiscard]] Eigen::MatrixXcd fitted_accelerance(const Curves& curves,
                                                  const ModalFit& fit,
                                                  Eigen::Index begin,
                                                  Eigen::Index count);

}  // namespace tapfit::modal
