#include "acquisition/hits/undersampled_pulses.hpp"

#include "acquisition/samples/statistics.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace tapfit::acquisition {
namespace {

using Eigen::Index;

// Longer ones ring too little behind a filter to be told, and are off by 8 % at
// most.
constexpr double short_pulse = 3.2;  // samples
// A sinc's first lobe has 21 % of its peak, the second, back above zero, 12 %;
// those of filters in use more than these. Where a hammer's charge amplifier
// lets zero drift, the force undershoots and comes back without a second one.
constexpr double rings = 0.04;
constexpr double rings_back = 0.02;
constexpr Index around = 12;
// A half sine is above a tenth of its peak for that share of its length.
constexpr double above_tenth = 0.936;

bool rings_beside(const HammerSignal& hammer, const Pulse& pulse) {
  const double noise = 4.0 * hammer.noise;
  for (const Index step : {1, -1}) {
    bool below = false;
    for (Index k = 1; k <= around; ++k) {
      const Index i = pulse.peak + step * k;
      if (i < 0 || i >= hammer.force.size()) break;
      const double force = hammer.force[i];
      if (below && force > rings_back * pulse.height + noise) return true;
      below = below || force < -rings * pulse.height - noise;
    }
  }
  return false;
}

}  // namespace

double impulse_error(double samples) {
  const double x = 0.5 * std::numbers::pi / samples;
  return 1.0 - x * std::cos(x) / std::sin(x);
}

std::string undersampled_statement(const std::vector<HammerRun>& runs,
                                   double rate) {
  std::vector<double> lengths;
  std::size_t ringing = 0;
  for (const HammerRun& run : runs) {
    for (const Pulse& pulse : run.pulses.pulses) {
      // Second blows and knocks say little.
      if (pulse.height < 0.3 * run.hammer.peak) continue;
      lengths.push_back(pulse.width / above_tenth);
      ringing += rings_beside(run.hammer, pulse) ? 1 : 0;
    }
  }
  if (lengths.empty() || 2 * ringing > lengths.size()) return {};
  const double typical = median(lengths);
  if (typical >= short_pulse) return {};
  return fmt::format(
      "pulses last {:.2g} samples and show no anti-alias filter: the force's "
      "scale, and that of every FRF with it, is off by up to {:.0f} %, each "
      "time otherwise. Frequencies and damping are not touched; for masses and "
      "modal scale record at {:.3g} Hz or more, or with the filter on",
      typical,
      100.0 * std::min(1.0, impulse_error(std::max(1.0, typical))),
      rate * 5.0 / std::max(1.0, typical));
}

}  // namespace tapfit::acquisition
