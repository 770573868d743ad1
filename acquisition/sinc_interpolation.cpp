#include "acquisition/sinc_interpolation.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

namespace tapfit::acquisition {

double interpolate(const Eigen::VectorXd& signal, double position) {
  constexpr double half = 16.0;
  constexpr double pi = std::numbers::pi;
  const auto from = static_cast<Eigen::Index>(std::ceil(position - half));
  const auto to = static_cast<Eigen::Index>(std::floor(position + half));
  double sum = 0.0;
  for (Eigen::Index n = std::max<Eigen::Index>(0, from);
       n <= std::min(to, signal.size() - 1);
       ++n) {
    const double x = position - static_cast<double>(n);
    if (std::abs(x) < 1e-9) return signal[n];
    sum += signal[n] * std::sin(pi * x) / (pi * x) *
           (0.5 + 0.5 * std::cos(pi * x / half));
  }
  return sum;
}

Peak interpolated_peak(const Eigen::VectorXd& signal, Eigen::Index sample) {
  constexpr int steps = 16;
  constexpr double step = 1.0 / steps;
  std::array<double, 2 * steps + 1> values{};
  const auto centre = static_cast<double>(sample);
  for (std::size_t k = 0; k < values.size(); ++k) {
    const double offset = static_cast<double>(k) - steps;
    values[k] = interpolate(signal, centre + offset * step);
  }
  const auto best = std::max_element(values.begin() + 1, values.end() - 1);
  const double left = *(best - 1);
  const double right = *(best + 1);
  const double bend = 2.0 * *best - left - right;
  Peak peak;
  peak.position =
      centre + static_cast<double>(best - values.begin() - steps) * step;
  peak.height = *best;
  if (bend > 0.0 && *best >= left && *best >= right) {
    const double shift = 0.5 * (right - left) / bend;
    peak.position += shift * step;
    peak.height += 0.25 * (right - left) * shift;
  }
  return peak;
}

}  // namespace tapfit::acquisition
