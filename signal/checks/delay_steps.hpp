// Where a channel's delay changes between hits: a recorder that loses samples
// of one channel shifts all that follows, one with a clock of its own drifts.
//
// Hits are parted where two constants fit their delays best, each part again,
// as long as the step is more than chance and noise make. Before that a line
// over time is tried.
#pragma once

#include "signal/checks/hit_delays.hpp"

#include <Eigen/Core>

#include <optional>
#include <vector>

namespace tapfit::signal {

struct DelayStepLimits {
  double worth_saying = 0.1;  ///< of a sample
  /// Standard deviations of a step: chance has thousands of tries in a test of
  /// many runs and channels, and lines share more than their noise.
  double significance = 8.0;
  /// What delays explain, against what lines that move along omega do; or what
  /// these leave, against what delays do.
  double rather_delay = 2.0;
  /// Share of what hits differ by that delays may leave, or that many times
  /// what noise and the usual scatter let expect.
  double left = 0.5;
  double left_times = 2.0;
  /// rms of what parts of the band want otherwise, in shares of the step.
  double parts_differ = 0.35;
  /// Share of a hit that must be the common FRF, beyond its own part of that.
  double alike = 0.3;
  Eigen::Index fewest_for_drift = 4;
  double off_line = 0.1;  ///< share of the delays' squares beside the line
  /// Of a drift, the largest step between two hits.
  double largest_part = 0.6;
};

struct DelayStep {
  Eigen::Index first = 0;  ///< hit from which on the delay is another
  Eigen::Index begin = 0;  ///< hits [begin, first) against [first, end)
  Eigen::Index end = 0;
  double delay_s = 0.0;  ///< by how much later responses come from there on
  double sd_s = 0.0;
};

struct DelayHistory {
  std::vector<DelayStep> steps;  ///< in the order of hits
  /// From the first hit to the last, where the delay grows evenly.
  std::optional<DelayStep> drift;
};

/// @param time_s of the hits; empty: no clock ran through, no drift is tried
/// @param sample_s sampling interval [s]
[[nodiscard]] DelayHistory delay_history(const HitDelays& of,
                                         const Eigen::VectorXd& time_s,
                                         double sample_s,
                                         const DelayStepLimits& limits = {});

}  // namespace tapfit::signal
