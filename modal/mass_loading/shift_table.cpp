#include "modal/mass_loading/shift_table.hpp"

#include <Eigen/Dense>

#include <algorithm>
#include <cmath>

namespace tapfit::modal {
namespace {

using Eigen::Index;

// Of ln w; poles are never known better, and one of no variance would decide
// alone.
constexpr double least_deviation = 1e-7;
constexpr double huber = 2.5;  // of standard deviations

struct Place {
  Index set_up = 0;
  Index mode = 0;
};

std::vector<Place> found_poles(const ShiftData& data) {
  std::vector<Place> places;
  for (Index r = 0; r < data.log_sd.cols(); ++r) {
    if ((data.log_sd.col(r).array() > 0.0).count() < 2) continue;
    for (Index k = 0; k < data.log_sd.rows(); ++k) {
      if (data.log_sd(k, r) > 0.0) places.push_back({k, r});
    }
  }
  return places;
}

/// What a fit leaves, over the standard deviations given.
struct Left {
  Eigen::VectorXd z;
  double excess = 0.0;  ///< chi^2 above its degrees of freedom
};

Left left_with(const Eigen::MatrixXd& X,
               const Eigen::VectorXd& y,
               const Eigen::VectorXd& variance) {
  const Eigen::VectorXd weight = variance.cwiseSqrt().cwiseInverse();
  const Eigen::MatrixXd white_X = weight.asDiagonal() * X;
  const Eigen::VectorXd white_y = weight.cwiseProduct(y);
  Eigen::ColPivHouseholderQR<Eigen::MatrixXd> solver;
  solver.setThreshold(1e-10);
  solver.compute(white_X);
  Left left;
  left.z = white_y - white_X * solver.solve(white_y);
  const Index dof = y.size() - solver.rank();
  if (dof > 0) left.excess = left.z.squaredNorm() - static_cast<double>(dof);
  return left;
}

/// tau^2 of Paule and Mandel by bisection on its logarithm; 0 where chi^2 is
/// below its degrees of freedom without.
double common_scatter(const Eigen::MatrixXd& X,
                      const Eigen::VectorXd& y,
                      const Eigen::VectorXd& variance) {
  if (left_with(X, y, variance).excess <= 0.0) return 0.0;
  double low = std::log(variance.minCoeff()) - 5.0;
  double high = 0.0;
  while (high - low > 0.01) {
    const double middle = 0.5 * (low + high);
    const Eigen::VectorXd wider = variance.array() + std::exp(middle);
    (left_with(X, y, wider).excess > 0.0 ? low : high) = middle;
  }
  return std::exp(high);
}

}  // namespace

ShiftTable shift_table(const ShiftData& data) {
  const std::vector<Place> places = found_poles(data);
  const auto n = static_cast<Index>(places.size());
  const auto sensors = static_cast<Index>(data.phi.size());
  ShiftTable table;
  table.log_omega.resize(n);
  table.variance.resize(n);
  table.g.resize(n, sensors);
  table.g_sd.resize(n, sensors);
  for (Index i = 0; i < n; ++i) {
    const Place& place = places[static_cast<std::size_t>(i)];
    table.set_up.push_back(place.set_up);
    table.mode.push_back(place.mode);
    table.log_omega(i) = data.log_omega(place.set_up, place.mode);
    table.variance(i) = std::pow(
        std::max(data.log_sd(place.set_up, place.mode), least_deviation), 2);
    for (Index q = 0; q < sensors; ++q) {
      const auto sensor = static_cast<std::size_t>(q);
      const auto set_up = static_cast<std::size_t>(place.set_up);
      const Eigen::VectorXd phi = data.phi[sensor][set_up].col(place.mode);
      const Eigen::VectorXd sd = data.phi_sd[sensor][set_up].col(place.mode);
      table.g(i, q) = 0.5 * phi.squaredNorm();
      table.g_sd(i, q) = phi.cwiseProduct(sd).norm();
    }
  }
  return table;
}

Eigen::MatrixXd mode_columns(const ShiftTable& table) {
  const Index last = *std::ranges::max_element(table.mode);
  Eigen::MatrixXd X = Eigen::MatrixXd::Zero(table.rows(), last + 1);
  for (Index i = 0; i < table.rows(); ++i) {
    X(i, table.mode[static_cast<std::size_t>(i)]) = 1.0;
  }
  return X;
}

Eigen::MatrixXd set_up_columns(const ShiftTable& table) {
  const Index last = *std::ranges::max_element(table.set_up);
  Eigen::MatrixXd X = Eigen::MatrixXd::Zero(table.rows(), last + 1);
  for (Index i = 0; i < table.rows(); ++i) {
    X(i, table.set_up[static_cast<std::size_t>(i)]) = 1.0;
  }
  return X;
}

Eigen::MatrixXd beside(const Eigen::MatrixXd& a, const Eigen::MatrixXd& b) {
  Eigen::MatrixXd both(a.rows(), a.cols() + b.cols());
  both << a, b;
  return both;
}

Eigen::VectorXd robust_variance(const Eigen::MatrixXd& X,
                                const Eigen::VectorXd& y,
                                const Eigen::VectorXd& variance) {
  Eigen::VectorXd result = variance;
  for (int round = 0; round < 3; ++round) {
    result.array() += common_scatter(X, y, result);
    const Eigen::ArrayXd z = left_with(X, y, result).z.array().abs() / huber;
    if (z.maxCoeff() <= 1.0) break;
    result = result.array() * z.max(1.0);
  }
  return result;
}

}  // namespace tapfit::modal
