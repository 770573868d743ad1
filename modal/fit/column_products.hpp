// Inner products of the columns of a modal model, weighted over all lines,
// without the columns themselves. With y the weighted FRFs
//
//   <f, y> = Re sum_k v_k^2 conj(f(s_k)) y_k
//
// every product with a pole's functions g_p = s^2 / (s - lambda)^p, p = 1, 2,
// is a Cauchy sum, because conj(s) = 2 sigma - s on the lines:
//
//   sum v^2 conj(g_1) y = -sum v^2 conj(s^2) y / (s - mu),
//   mu = 2 sigma - conj(lambda)
//
// and those of two poles a, b are by partial fractions, with rho = v^2 |s|^4
// and D_p(a) = sum rho / (s - a)^p,
//
//   P(a, b) = sum rho conj(1 / (s - a)) / (s - b)
//           = (conj(D_1(a)) + D_1(b)) / (2 sigma - conj(a) - b)
//
// The columns that multiply Re R and Im R of a mode are g + h and j (g - h),
// h that of the conjugate pole.
#pragma once

#include "modal/poles/weighted_frfs.hpp"

#include <Eigen/Core>

namespace tapfit::modal {

/// sum_k v^2 conj(g_p) x of each pole with the FRFs, the residual terms and
/// s^2: n_columns x n_poles.
struct PoleSums {
  Eigen::MatrixXcd own[2];        ///< p = 1, 2, of lambda
  Eigen::MatrixXcd conjugate[2];  ///< of conj(lambda)
};

[[nodiscard]] PoleSums pole_sums(const WeightedFrfs& curves,
                                 const Eigen::VectorXcd& poles);

/// Products of the columns of a model, which are 2 n_modes of its poles' and
/// 2 n_terms of residual terms (fit_columns.hpp), among them and with the FRFs.
struct ColumnProducts {
  Eigen::MatrixXd gram;  ///< n_columns square
  Eigen::MatrixXd frfs;  ///< n_columns x n_frfs
};

[[nodiscard]] ColumnProducts column_products(const WeightedFrfs& curves,
                                             const Eigen::VectorXcd& poles,
                                             const PoleSums& sums);

/// Products of the columns' derivatives to their poles.
struct DerivativeProducts {
  Eigen::MatrixXd columns;  ///< with the columns, n_columns x 2 n_modes
  Eigen::MatrixXd gram;     ///< among them, 2 n_modes square
  Eigen::MatrixXd frfs;     ///< 2 n_modes x n_frfs
};

[[nodiscard]] DerivativeProducts derivative_products(
    const WeightedFrfs& curves,
    const Eigen::VectorXcd& poles,
    const PoleSums& sums);

}  // namespace tapfit::modal
