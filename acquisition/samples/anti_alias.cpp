#include "acquisition/samples/anti_alias.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace tapfit::acquisition {
namespace {

constexpr double attenuation_db = 100.0;

// Modified Bessel function of the first kind and order zero, by its series
// I0(x) = sum over k of ((x/2)^k / k!)^2 (Abramowitz and Stegun 9.6.12). The
// library's calls lgamma, which writes a global: not for several threads.
double bessel_i0(double x) {
  double term = 1.0;
  double sum = 1.0;
  for (int k = 1; term > 1e-17 * sum; ++k) {
    const double factor = x / (2.0 * k);
    term *= factor * factor;
    sum += term;
  }
  return sum;
}

}  // namespace

Eigen::VectorXd anti_alias_taps(int oversampling) {
  // Of the fast rate: width of the transition and its middle.
  const double width = 0.4 / oversampling;
  const double cutoff = 0.5 / oversampling;
  const double beta = 0.1102 * (attenuation_db - 8.7);
  const auto half = static_cast<Eigen::Index>(std::ceil(
      (attenuation_db - 8.0) / (2.285 * 2.0 * std::numbers::pi * width) / 2.0));
  Eigen::VectorXd taps(2 * half + 1);
  for (Eigen::Index n = -half; n <= half; ++n) {
    const double x = 2.0 * std::numbers::pi * cutoff * static_cast<double>(n);
    const double sinc = n == 0 ? 1.0 : std::sin(x) / x;
    const double u = static_cast<double>(n) / static_cast<double>(half);
    taps(n + half) = sinc * bessel_i0(beta * std::sqrt(1.0 - u * u));
  }
  return taps / taps.sum();
}

Eigen::MatrixXd decimate(const Eigen::Ref<const Eigen::MatrixXd>& fast,
                         int oversampling) {
  const Eigen::VectorXd taps = anti_alias_taps(oversampling);
  const Eigen::Index half = taps.size() / 2;
  const Eigen::Index count = (fast.rows() + oversampling - 1) / oversampling;
  Eigen::MatrixXd slow(count, fast.cols());
  for (Eigen::Index m = 0; m < count; ++m) {
    const Eigen::Index centre = m * oversampling;
    const Eigen::Index first = std::max<Eigen::Index>(centre - half, 0);
    const Eigen::Index last = std::min(centre + half, fast.rows() - 1);
    const Eigen::Index length = last - first + 1;
    const auto weights = taps.segment(first - centre + half, length);
    for (Eigen::Index c = 0; c < fast.cols(); ++c) {
      slow(m, c) = weights.dot(fast.col(c).segment(first, length));
    }
  }
  return slow;
}

}  // namespace tapfit::acquisition
