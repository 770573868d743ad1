#include "acquisition/hits/judge_hits.hpp"

#include "acquisition/samples/statistics.hpp"

#include <algorithm>
#include <cmath>
#include <complex>
#include <limits>
#include <numbers>

namespace tapfit::acquisition {
namespace {

using Eigen::Index;

// The main pulse's spectrum by a direct sum, at a frequency in cycles per
// sample [N].
double force_spectrum(const HammerSignal& hammer,
                      const Pulse& main,
                      double frequency) {
  const auto reach =
      std::max<Index>(4, static_cast<Index>(std::ceil(1.5 * main.width)));
  const Index from = std::max<Index>(0, main.peak - reach);
  const Index to = std::min(hammer.force.size() - 1, main.peak + reach);
  const Eigen::VectorXd force = hammer.force.segment(from, to - from + 1);
  const double step = 2.0 * std::numbers::pi * frequency;
  // Horner's rule from the last sample on; only the magnitude is asked for.
  const std::complex<double> turn = std::polar(1.0, -step);
  std::complex<double> sum = 0.0;
  for (Index i = force.size(); i-- > 0;) sum = sum * turn + force[i];
  return std::abs(sum);
}

double decibels(double value, double reference) {
  return 20.0 * std::log10(std::max(value, 1e-12) / std::max(reference, 1e-12));
}

}  // namespace

double force_reach_hz(const HammerSignal& hammer,
                      const Pulse& main,
                      double fallen_db,
                      double most_hz,
                      double sample_rate_hz) {
  const double most = most_hz / sample_rate_hz;
  const double low = force_spectrum(hammer, main, 0.0);
  const auto fallen = [&](double frequency) {
    return decibels(force_spectrum(hammer, main, frequency), low) < fallen_db;
  };
  // A twentieth of 1 / width is small beside a main lobe, which is 2 / width
  // wide or more (a half sine's: 3), and a zero is not stepped over.
  const double step = 0.05 / std::max(1.0, main.width);
  double above = 0.0;
  while (above < most && !fallen(std::min(above + step, most))) above += step;
  if (above >= most) return most_hz;
  double below = std::min(above + step, most);
  constexpr int halvings = 7;  // to 1 in 2000 of 1 / width
  for (int k = 0; k < halvings; ++k) {
    const double middle = 0.5 * (above + below);
    (fallen(middle) ? below : above) = middle;
  }
  return below * sample_rate_hz;
}

double difference_noise(const Eigen::Ref<const Eigen::VectorXd>& channel) {
  const Index n = channel.size() - 1;
  if (n < 1) return 0.0;
  const Index part = std::max<Index>(1, n / 16);
  // Pairs of neighbours from the whole part; 4096 give a median to 2 %. Those
  // side by side come from memory at once.
  constexpr Index enough = 4096;
  constexpr Index together = 32;
  const Index stride = std::max<Index>(1, part / enough);
  double quietest = std::numeric_limits<double>::max();
  for (Index from = 0; from + part <= n; from += part) {
    Eigen::VectorXd steps((part + stride - 1) / stride);
    for (Index k = 0; k < steps.size(); ++k) {
      const Index i = from + k / together * together * stride + k % together;
      steps[k] = std::abs(channel[i + 1] - channel[i]);
    }
    // A part of which at least half is above is not quieter.
    if (2 * (steps.array() < quietest).count() <= steps.size()) continue;
    quietest = std::min(quietest, median(std::move(steps)));
  }
  return 1.4826 / std::numbers::sqrt2 * quietest;
}

}  // namespace tapfit::acquisition
