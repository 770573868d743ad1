#include "acquisition/samples/sinc_interpolation.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

namespace tapfit::acquisition {
namespace {

constexpr double half = 16.0;  // samples to either side
constexpr double pi = std::numbers::pi;

double kernel(double x) {
  return std::sin(pi * x) / (pi * x) * (0.5 + 0.5 * std::cos(pi * x / half));
}

}  // namespace

double interpolate(const Eigen::VectorXd& signal, double position) {
  const auto from = static_cast<Eigen::Index>(std::ceil(position - half));
  const auto to = static_cast<Eigen::Index>(std::floor(position + half));
  double sum = 0.0;
  for (Eigen::Index n = std::max<Eigen::Index>(0, from);
       n <= std::min(to, signal.size() - 1);
       ++n) {
    const double x = position - static_cast<double>(n);
    if (std::abs(x) < 1e-9) return signal[n];
    sum += signal[n] * kernel(x);
  }
  return sum;
}

Eigen::VectorXd interpolated(const Eigen::VectorXd& signal,
                             Eigen::Index first,
                             Eigen::Index last,
                             Eigen::Index steps) {
  constexpr auto reach = static_cast<Eigen::Index>(half);
  Eigen::VectorXd values((last - first) * steps + 1);
  Eigen::VectorXd taps(2 * reach);  // of samples -reach + 1 .. reach
  for (Eigen::Index step = 0; step < steps; ++step) {
    const double part = static_cast<double>(step) / static_cast<double>(steps);
    for (Eigen::Index k = 0; k < taps.size() && step > 0; ++k) {
      taps[k] = kernel(part - static_cast<double>(k + 1 - reach));
    }
    for (Eigen::Index n = first; n <= last; ++n) {
      const Eigen::Index at = (n - first) * steps + step;
      if (at >= values.size()) break;
      const Eigen::Index from = std::max<Eigen::Index>(0, n + 1 - reach);
      const Eigen::Index to = std::min(signal.size() - 1, n + reach);
      values[at] = step == 0 ? signal[n]
                             : taps.segment(from - n - 1 + reach, to - from + 1)
                                   .dot(signal.segment(from, to - from + 1));
    }
  }
  return values;
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
