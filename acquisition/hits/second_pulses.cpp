#include "acquisition/hits/second_pulses.hpp"

#include "acquisition/samples/sinc_interpolation.hpp"

#include <algorithm>
#include <cmath>

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

// Notes a pulse; of what the same blow shows twice, the higher.
void add(const Pulse& pulse, Index near, std::vector<Pulse>& pulses) {
  if (pulses.empty() || pulse.peak - pulses.back().peak >= near) {
    pulses.push_back(pulse);
  } else if (pulse.height > pulses.back().height) {
    pulses.back() = pulse;
  }
}

}  // namespace

std::vector<Pulse> second_pulses(const HammerSignal& hammer,
                                 const Pulse& main,
                                 Index begin,
                                 Index end,
                                 double least_share) {
  const double limit =
      std::max(0.9 * least_share * main.height, 6.5 * hammer.noise);
  const Eigen::VectorXd force = without_ringing(hammer.force, main, begin, end);
  const Index first = std::max<Index>(0, begin);
  const Index main_peak = main.peak - first;
  const auto near =
      std::max<Index>(4, static_cast<Index>(std::ceil(1.4 * main.width)));
  const auto around =
      std::max<Index>(3, static_cast<Index>(std::ceil(main.width)));
  std::vector<Pulse> pulses;
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
    Pulse pulse = measure_pulse(force, k);
    if (pulse.height < limit || pulse.width > 8.0 * main.width) continue;
    if (pulse.height <= 1.5 * swing_below(force, k, around)) continue;
    pulse.first = pulse.peak += first;
    pulse.centre += static_cast<double>(first);
    add(pulse, near, pulses);
  }
  return pulses;
}

}  // namespace tapfit::acquisition
