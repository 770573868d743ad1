#include "acquisition/hits/hammer_pulses.hpp"

#include "acquisition/samples/range.hpp"
#include "acquisition/samples/sinc_interpolation.hpp"
#include "acquisition/samples/statistics.hpp"

#include <algorithm>
#include <cmath>

namespace tapfit::acquisition {
namespace {

// Samples from the peak to where the force falls below `share` of it, with a
// straight line between the two samples around that point.
double flank(const BaselineFree& force,
             Eigen::Index peak,
             int step,
             double share) {
  const double level = share * force[peak];
  Eigen::Index i = peak;
  while (i + step >= 0 && i + step < force.size()) {
    const double here = force[i];
    const double next = force[i + step];
    if (next < level) {
      const double part = (here - level) / (here - next);
      return std::abs(static_cast<double>(i - peak)) + part;
    }
    i += step;
  }
  return std::abs(static_cast<double>(i - peak)) + 1.0;
}

// The range within what the pieces bound: few of these reach so far that the
// samples must be looked at.
Range exact_range(const BaselineFree& force, const std::vector<Range>& pieces) {
  Range exact;
  const auto look = [&](std::ptrdiff_t piece) {
    const Eigen::Index first = piece_length * piece;
    const Range range = range_of(
        force.segment(first, std::min(piece_length, force.size() - first)));
    exact = {std::min(exact.low, range.low), std::max(exact.high, range.high)};
  };
  if (pieces.empty()) return exact;
  look(std::ranges::min_element(pieces, {}, &Range::low) - pieces.begin());
  look(std::ranges::max_element(pieces, {}, &Range::high) - pieces.begin());
  for (std::size_t p = 0; p < pieces.size(); ++p) {
    if (pieces[p].low < exact.low || pieces[p].high > exact.high) {
      look(static_cast<std::ptrdiff_t>(p));
    }
  }
  return exact;
}

}  // namespace

HammerSignal prepare_hammer(const Eigen::Ref<const Eigen::VectorXd>& channel,
                            double sample_rate_hz,
                            std::optional<int> polarity) {
  // Half a second is long beside any pulse and short beside thermal drift.
  const auto half_second = static_cast<Eigen::Index>(0.5 * sample_rate_hz);
  const Eigen::Index segment = std::max<Eigen::Index>(64, half_second);
  HammerSignal signal;
  signal.force = BaselineFree(channel, segment);
  signal.pieces = signal.force.pieces();
  const auto [low, high] = exact_range(signal.force, signal.pieces);
  // Undershoot after a blow stays well below the blow itself.
  const bool down = polarity ? *polarity < 0 : -low > 1.5 * high;
  if (down) {
    signal.polarity = -1.0;
    signal.force.turn();
    for (Range& piece : signal.pieces) piece = {-piece.high, -piece.low};
  }
  signal.peak = std::max(0.0, down ? -low : high);
  constexpr Eigen::Index enough = 1 << 13;
  signal.noise = 1.4826 * median(signal.force.thinned(enough).cwiseAbs());
  signal.noise = std::max(signal.noise, 1e-6 * signal.peak);
  return signal;
}

Pulse measure_pulse(const BaselineFree& force, Eigen::Index peak) {
  Pulse pulse;
  pulse.first = peak;
  pulse.peak = peak;
  pulse.height = force[peak];
  pulse.centre = static_cast<double>(peak);
  pulse.width = flank(force, peak, -1, 0.1) + flank(force, peak, 1, 0.1);
  // A wide pulse is sampled well enough as it is.
  if (pulse.width < 12.0) {
    constexpr Eigen::Index context = 20;  // beyond what interpolation needs
    const Eigen::Index first = std::max<Eigen::Index>(0, peak - context);
    const Eigen::Index last = std::min(force.size() - 1, peak + context);
    const Peak between =
        interpolated_peak(force.segment(first, last - first + 1), peak - first);
    pulse.centre = static_cast<double>(first) + between.position;
    pulse.height = std::max(pulse.height, between.height);
  }
  return pulse;
}

std::vector<Pulse> find_pulses(const BaselineFree& force,
                               const std::vector<Range>& pieces,
                               double level,
                               double rearm) {
  std::vector<Pulse> pulses;
  const Eigen::Index n = force.size();
  for (Eigen::Index i = 0; i < n; ++i) {
    // Most of a record is quiet and is passed over by pieces.
    if (pieces[static_cast<std::size_t>(i / piece_length)].high <= level) {
      i += piece_length - i % piece_length - 1;
      continue;
    }
    if (force[i] <= level) continue;
    const Eigen::Index first = i;
    Eigen::Index peak = i;
    Eigen::Index last_high = i;
    Eigen::Index dead = 4;
    for (; i < n && i - last_high <= dead; ++i) {
      if (force[i] > rearm * level) last_high = i;
      if (force[i] > force[peak]) peak = i;
      dead = std::max<Eigen::Index>(4, (last_high - first) / 2);
    }
    Pulse pulse = measure_pulse(force, peak);
    pulse.first = first;
    pulses.push_back(pulse);
  }
  return pulses;
}

}  // namespace tapfit::acquisition
