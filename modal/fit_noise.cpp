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
  const double mean = std::max(power.mean(), 1e-300);
  noise.per_frf = (power.colwise().mean().transpose() / mean).cwiseSqrt();
  return noise;
}

}  // namespace tapfit::modal
