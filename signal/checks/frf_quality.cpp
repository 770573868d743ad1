#include "signal/checks/frf_quality.hpp"

#include "acquisition/samples/statistics.hpp"

#include <cmath>

namespace tapfit::signal {

std::vector<FrfQuality> frf_quality(
    const FrfSet& set, const std::optional<std::array<double, 2>>& band_hz) {
  const Eigen::VectorXd f = set.frequency_hz();
  std::vector<FrfQuality> result;
  for (const Frf& frf : set.frfs) {
    double coherence = 0.0;
    int lines = 0;
    std::vector<double> sd;
    for (Eigen::Index i = 0; i < f.size(); ++i) {
      if (band_hz && (f(i) < (*band_hz)[0] || f(i) > (*band_hz)[1])) continue;
      coherence += frf.coherence(i);
      ++lines;
      const double size = std::abs(frf.H(i));
      if (size > 0.0) sd.push_back(100.0 * std::sqrt(frf.variance(i)) / size);
    }
    result.push_back(
        {lines > 0 ? coherence / lines : 0.0, acquisition::median(sd)});
  }
  return result;
}

}  // namespace tapfit::signal
