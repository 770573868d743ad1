// The room modal/statistics. Least squares and the tails of distributions that
// decisions on modes need.
// In:  Numbers.
// Out: Estimates, covariances, probabilities.
// May include: its row in CONTRIBUTING.md.
//
// Weighted linear least squares with what hypothesis tests need of it.
//
//   min_b (y - X b)' V^-1 (y - X b)
//
//   F = (chi2_without - chi2_with) / (rank_with - rank_without)
//       / (chi2_with / dof_with)
//
// Whether further columns fit better than chance is judged by F, in which a
// common factor on V cancels.
#pragma once

#include <Eigen/Core>

namespace tapfit::signal {

struct WeightedFit {
  Eigen::VectorXd coefficients;  ///< per column; smallest where not determined
  Eigen::MatrixXd covariance;    ///< of the coefficients for V as given
  Eigen::VectorXd left;          ///< y - X b
  double chi2 = 0.0;
  Eigen::Index rank = 0;
  Eigen::Index dof = 0;  ///< rows - rank
};

/// @param X n x p
/// @param y n
/// @param V covariance of y, n x n, positive definite
[[nodiscard]] WeightedFit fit_weighted(const Eigen::MatrixXd& X,
                                       const Eigen::VectorXd& y,
                                       const Eigen::MatrixXd& V);

/// P that the columns which only `with` has gain as much by chance; 1 when they
/// add no rank or nothing is left to judge by.
[[nodiscard]] double chance_of_gain(const WeightedFit& with,
                                    const WeightedFit& without);

}  // namespace tapfit::signal
