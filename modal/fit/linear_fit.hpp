// Residues and residual terms for given poles: linear least squares with
// columns of unit length,
//
//   Phi S^-1 = Q R,   R (S c) = Q' y
//
// On few lines Q and R come from the columns. On many R is Cholesky's factor of
// the products Phi' Phi and Q' y = R^-T S^-1 Phi' y, which need no pass over
// the lines (column_products.hpp); that is exact to the square of the columns'
// condition, far below the noise of any measurement.
#pragma once

#include "modal/fit/column_products.hpp"
#include "modal/poles/weighted_frfs.hpp"

#include <Eigen/Core>

namespace tapfit::modal {

struct LinearFit {
  Eigen::VectorXd scale;         ///< S: length of each column
  Eigen::MatrixXd R;             ///< upper triangular
  Eigen::MatrixXd explained;     ///< Q' y, n_columns x n_frfs
  Eigen::MatrixXd coefficients;  ///< c of u H, n_columns x n_frfs
  double misfit = 0.0;           ///< weighted squares that are left
  PoleSums sums;                 ///< of many lines
  Eigen::MatrixXd Q;             ///< of few lines: 2 n_lines x n_columns
  Eigen::MatrixXd left;          ///< of them: y - Q Q' y, 2 n_lines x n_frfs
};

/// @param poles [rad/s]; columns that all but coincide share what they explain
[[nodiscard]] LinearFit fit_linear(const WeightedFrfs& curves,
                                   const Eigen::VectorXcd& poles);

/// The two ways of it, for few lines and for many.
[[nodiscard]] LinearFit fit_by_columns(const WeightedFrfs& curves,
                                       const Eigen::VectorXcd& poles);
[[nodiscard]] LinearFit fit_by_products(const WeightedFrfs& curves,
                                        const Eigen::VectorXcd& poles);

/// R^-T S^-1 x: Q' y of x = Phi' y.
[[nodiscard]] Eigen::MatrixXd explained_by(const LinearFit& linear,
                                           const Eigen::MatrixXd& x);

/// S^-1 R^-1 x: the coefficients of x = Q' y.
[[nodiscard]] Eigen::MatrixXd coefficients_for(const LinearFit& linear,
                                               const Eigen::MatrixXd& x);

/// Q on all lines, 2 n_lines x n_columns.
[[nodiscard]] Eigen::MatrixXd orthonormal_columns(const WeightedFrfs& curves,
                                                  const Eigen::VectorXcd& poles,
                                                  const LinearFit& linear);

/// Phi on some lines, not weighted: real over imaginary parts,
/// 2 count x n_columns.
[[nodiscard]] Eigen::MatrixXd model_columns(const WeightedFrfs& curves,
                                            const Eigen::VectorXcd& poles,
                                            Eigen::Index begin,
                                            Eigen::Index count);

}  // namespace tapfit::modal
