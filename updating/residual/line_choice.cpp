#include "updating/residual/line_choice.hpp"

#include <algorithm>
#include <cmath>

namespace tapfit::updating {

using Eigen::Index;
using Eigen::VectorXd;

VectorXd even_lines(double high_hz, double step_hz) {
  const auto count = static_cast<Index>(std::floor(high_hz / step_hz + 1e-9));
  return VectorXd::LinSpaced(
      count, step_hz, step_hz * static_cast<double>(count));
}

VectorXd random_lines(double high_hz,
                      int count,
                      acquisition::SeededRandom& random) {
  VectorXd lines(count);
  for (double& f : lines) f = random.uniform(0.0, high_hz);
  std::sort(lines.begin(), lines.end());
  return lines;
}

VectorXd lines_before_peaks(const VectorXd& resonances_hz,
                            double before_hz,
                            double step_hz,
                            int count) {
  VectorXd lines(resonances_hz.size() * count);
  Index at = 0;
  for (const double peak : resonances_hz) {
    for (int k = 0; k < count; ++k) {
      lines(at++) = peak - before_hz + step_hz * k;
    }
  }
  std::sort(lines.begin(), lines.end());
  return lines;
}

std::vector<bool> off_peaks(const VectorXd& lines_hz,
                            const VectorXd& measured_hz,
                            const VectorXd& model_hz,
                            const PeakRule& rule) {
  const Index modes = std::min(measured_hz.size(), model_hz.size());
  std::vector<bool> use;
  for (const double f : lines_hz) {
    bool free = true;
    double last = -1e300;  // the resonance below
    for (Index m = 0; m < modes; ++m) {
      const double low = std::min(measured_hz(m), model_hz(m));
      const double high = std::max(measured_hz(m), model_hz(m));
      const double half = 0.5 * rule.around_hz;
      if (f > low - half && f < high + half) free = false;
      if (low - last < rule.close_hz && f > last && f < high) free = false;
      last = high;
    }
    use.push_back(free);
  }
  return use;
}

}  // namespace tapfit::updating
