#include "modal/fit_noise.hpp"

#include <algorithm>
#include <cmath>
#include <complex>

namespace tapfit::modal {
namespace {

using Complex = std::complex<double>;
using Eigen::Index;
constexpr Complex j{0.0, 1.0};

}  // namespace

Eigen::MatrixXcd correlate(const Eigen::MatrixXcd& x, double ratio) {
  if (ratio <= 0.0) return x;
  constexpr Index kReach = 24;
  Eigen::MatrixXcd result = x;
  for (Index d = 1; d <= std::min(kReach, x.rows() - 1); ++d) {
    const Complex rho =
        1.0 / (1.0 + j * static_cast<double>(d) / (2.0 * ratio));
    const Index n = x.rows() - d;
    result.bottomRows(n) += rho * x.topRows(n);
    result.topRows(n) += std::conj(rho) * x.bottomRows(n);
  }
  return result;
}

Noise weighted_noise(const Curves& curves, const ModalFit& fit) {
  const Index lines = curves.lines();
  Eigen::MatrixXd power(lines, curves.count());
  const Eigen::MatrixXd left = (curves.H - fit.H).cwiseAbs2();
  for (Index k = 0; k < lines; ++k) {
    const Index begin = std::max<Index>(0, k - 5);
    const Index n = std::min(lines, k + 6) - begin;
    power.row(k) = left.middleRows(begin, n).colwise().mean().cwiseMax(
        curves.variance.middleRows(begin, n).colwise().mean());
  }
  power = fit.line_weight.cwiseAbs2().asDiagonal() * power *
          fit.frf_weight.cwiseAbs2().asDiagonal();
  Noise noise;
  noise.per_line = power.rowwise().mean().cwiseSqrt();
  noise.share =
      noise.per_line.cwiseAbs2().cwiseMax(1e-300).cwiseInverse().asDiagonal() *
      power;
  return noise;
}

Eigen::MatrixXd noise_at_modes(const Noise& noise, const Eigen::MatrixXcd& X) {
  const Index modes = X.cols() / 2;
  Eigen::MatrixXd told(X.rows(), modes);
  for (Index r = 0; r < modes; ++r) {
    told.col(r) = X.middleCols(2 * r, 2).rowwise().squaredNorm();
    told.col(r) /= std::max(told.col(r).sum(), 1e-300);
  }
  return (noise.share.transpose() * told).cwiseSqrt();
}

}  // namespace tapfit::modal
