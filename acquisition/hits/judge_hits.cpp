#include "acquisition/hits/judge_hits.hpp"

#include "acquisition/samples/sinc_interpolation.hpp"
#include "acquisition/samples/statistics.hpp"

#include <algorithm>
#include <cmath>
#include <complex>
#include <limits>
#include <numbers>

namespace tapfit::acquisition {
namespace {

using Eigen::Index;

constexpr Index ringing_reach = 40;  // samples to either side of a pulse

bool is_local_maximum(const Eigen::VectorXd& force, Index k) {
  return (k == 0 || force[k] >= force[k - 1]) &&
         (k + 1 == force.size() || force[k] > force[k + 1]);
}

// Whether a pulse rings before and after itself alike, as it does behind a
// linear-phase filter.
bool rings_both_ways(const BaselineFree& force, const Pulse& main) {
  const auto near =
      std::max<Index>(3, static_cast<Index>(std::ceil(main.width)));
  constexpr Index span = 8;
  if (main.peak < near + span || main.peak + near + span >= force.size()) {
    return false;
  }
  const double before =
      force.segment(main.peak - near - span, span).cwiseAbs().maxCoeff();
  const double after =
      force.segment(main.peak + near + 1, span).cwiseAbs().maxCoeff();
  return before > 0.3 * after && after > 0.3 * before;
}

// The block, with the pulse and its ringing taken off. A linear-phase filter
// rings alike before and after, so each side is freed of the other's mirror
// image. The pulse goes with it: cut off from its ringing it would reach far
// where heights are read between samples. Nothing is done behind a filter that
// rings only afterwards.
Eigen::VectorXd without_ringing(const BaselineFree& force,
                                const Pulse& main,
                                Index begin,
                                Index end) {
  const Index first = std::max<Index>(0, begin);
  const Index count = std::min(end, force.size()) - first;
  Eigen::VectorXd block = force.segment(first, count);
  if (main.width >= 12.0 || !rings_both_ways(force, main)) return block;
  const Index from = std::max<Index>(0, main.peak - first - ringing_reach);
  const Index to = std::min(count - 1, main.peak - first + ringing_reach);
  // As far as the mirror image reaches, and interpolation beyond that.
  constexpr Index context = ringing_reach + 20;
  const Index near = std::max<Index>(0, main.peak - context);
  const Eigen::VectorXd around = force.segment(
      near, std::min(force.size(), main.peak + context + 1) - near);
  const double centre = main.centre - static_cast<double>(near);
  for (Index k = from; k <= to; ++k) {
    const auto at = static_cast<double>(first + k - near);
    block[k] -= interpolate(around, 2.0 * centre - at);
  }
  return block;
}

// How far the force swings below zero within some samples of a place, between
// the samples too: ringing is sampled but two or three times a period.
double swing_below(const Eigen::VectorXd& force, Index place, Index around) {
  const Index from = std::max<Index>(0, place - around);
  const Index to = std::min(force.size() - 1, place + around);
  Index lowest = 0;
  const double sampled = -force.segment(from, to - from + 1).minCoeff(&lowest);
  lowest += from;
  constexpr Index context = 20;
  const Index first = std::max<Index>(0, lowest - context);
  const Index count = std::min<Index>(2 * context + 1, force.size() - first);
  const Eigen::VectorXd turned = -force.segment(first, count);
  return std::max(sampled, interpolated_peak(turned, lowest - first).height);
}

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

bool has_second_pulse(const HammerSignal& hammer,
                      const Pulse& main,
                      Index begin,
                      Index end,
                      double percent) {
  // A tenth below the limit, since the height of a pulse a few samples wide
  // is known no better.
  const double limit =
      std::max(0.009 * percent * main.height, 6.5 * hammer.noise);
  const Eigen::VectorXd force = without_ringing(hammer.force, main, begin, end);
  const Index first = std::max<Index>(0, begin);
  const Index main_peak = main.peak - first;
  const auto near =
      std::max<Index>(4, static_cast<Index>(std::ceil(1.4 * main.width)));
  const auto around =
      std::max<Index>(3, static_cast<Index>(std::ceil(main.width)));
  for (Index k = 0; k < force.size(); ++k) {
    // Most of a block is quiet and is passed over by pieces, but where ringing
    // was taken off these are no longer its ranges.
    const Index piece = (first + k) / piece_length;
    if (std::abs(k - main_peak) > ringing_reach + piece_length &&
        hammer.pieces[static_cast<std::size_t>(piece)].high < 0.7 * limit) {
      k = (piece + 1) * piece_length - first - 1;
      continue;
    }
    if (force[k] < 0.7 * limit || std::abs(k - main_peak) < near) continue;
    if (!is_local_maximum(force, k)) continue;
    // The mirror image of an undershoot is no blow: before the main pulse it
    // must be there as read. Nothing undershoots ahead of a blow, so what is
    // left behind it needs no such proof, though ringing may hide it.
    if (k < main_peak &&
        hammer.force[first + k] < 0.4 * std::max(force[k], limit)) {
      continue;
    }
    const Pulse pulse = measure_pulse(force, k);
    if (pulse.height < limit || pulse.width > 8.0 * main.width) continue;
    const double below = swing_below(force, k, around);
    if (pulse.height > 1.5 * below) return true;
  }
  return false;
}

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
