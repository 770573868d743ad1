#include "signal/statistics/weighted_fit.hpp"

#include "signal/statistics/tail_probability.hpp"

#include <Eigen/Dense>

#include <algorithm>

namespace tapfit::signal {

WeightedFit fit_weighted(const Eigen::MatrixXd& X,
                         const Eigen::VectorXd& y,
                         const Eigen::MatrixXd& V) {
  const Eigen::LLT<Eigen::MatrixXd> root(V);
  const Eigen::MatrixXd white_X = root.matrixL().solve(X);
  const Eigen::VectorXd white_y = root.matrixL().solve(y);
  Eigen::CompleteOrthogonalDecomposition<Eigen::MatrixXd> solver;
  solver.setThreshold(1e-10);
  solver.compute(white_X);
  WeightedFit fit;
  fit.coefficients = solver.solve(white_y);
  const Eigen::MatrixXd inverse = solver.pseudoInverse();
  fit.covariance = inverse * inverse.transpose();
  fit.left = y - X * fit.coefficients;
  fit.chi2 = (white_y - white_X * fit.coefficients).squaredNorm();
  fit.rank = solver.rank();
  fit.dof = y.size() - fit.rank;
  return fit;
}

double chance_of_gain(const WeightedFit& with, const WeightedFit& without) {
  const Eigen::Index more = with.rank - without.rank;
  if (more <= 0 || with.dof <= 0) return 1.0;
  const auto columns = static_cast<double>(more);
  const auto dof = static_cast<double>(with.dof);
  const double gain = std::max(0.0, without.chi2 - with.chi2) / columns;
  const double noise = std::max(with.chi2 / dof, 1e-300);
  return f_tail(gain / noise, columns, dof);
}

}  // namespace tapfit::signal
