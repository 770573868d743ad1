#include "acquisition/samples/rate_of_times.hpp"

#include <cmath>

namespace tapfit::acquisition {

std::optional<RateOfTimes> rate_of_times(const Eigen::VectorXd& time) {
  const Eigen::Index n = time.size();
  if (n < 2) return std::nullopt;
  const double whole = time[n - 1] - time[0];
  const double step = whole / static_cast<double>(n - 1);
  if (!(step > 0.0)) return std::nullopt;
  RateOfTimes result{1.0 / step, 0.0, std::nullopt};
  for (Eigen::Index i = 0; i < n; ++i) {
    const double off =
        std::abs(time[i] - time[0] - static_cast<double>(i) * step);
    if (!(off < 0.5 * step) && !result.uneven) result.uneven = i;
    result.spread = std::max(result.spread, 2.0 * off / whole);
  }
  return result;
}

}  // namespace tapfit::acquisition
