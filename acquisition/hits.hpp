// Hits found in the hammer channel, and what is thought of each.
#pragma once

#include "acquisition/recording.hpp"

#include <optional>
#include <string>
#include <vector>

namespace tapfit::acquisition {

enum class HitFault { Double, Overload, Weak, Soft, Truncated, Outlier, ByHand };

/// "double", "overload", "weak", "soft", "truncated", "outlier", "by hand".
[[nodiscard]] std::string name(HitFault fault);

struct Hit {
  Eigen::Index begin = 0;    ///< first sample of the block (pre-trigger in it)
  Eigen::Index trigger = 0;  ///< sample where the trigger level was crossed
  double time_s = 0.0;       ///< of the force's peak, from the file's start
  double peak_n = 0.0;
  double pulse_s = 0.0;      ///< width of the main pulse
  bool accepted = true;
  std::vector<HitFault> reasons;  ///< why it was judged out (empty when good)
};

struct HitSet {
  double sample_rate_hz = 0.0;
  Eigen::Index block = 0;        ///< samples per block, the same for all hits
  Eigen::Index pre_trigger = 0;  ///< samples of the block before the trigger
  double trigger_n = 0.0;        ///< level used [N]
  std::vector<std::vector<Hit>> runs;   ///< as TestBundle::runs
  std::vector<std::string> statements;  ///< what was chosen, and why
};

struct HitOptions {
  std::optional<double> trigger_percent;  ///< of the largest peak
  std::optional<double> pre_trigger_s;
  std::optional<double> block_s;
  double double_hit_percent = 5.0;  ///< second peak, of the main one
};

/// Finds and judges the hits of all runs.
///
/// The block is as long as the gaps between hits allow (and no longer than the
/// response lasts), the same for all hits.
///
/// @param band_hz used to judge how soft a hit is; empty: up to 0.4 of the
///   sampling rate
/// @throws InputError when a run holds no hit at all
[[nodiscard]] HitSet find_hits(const TestBundle& bundle,
                               const std::vector<Recording>& recordings,
                               const HitOptions& options);

/// Turns a hit's acceptance over by hand; notes HitFault::ByHand.
void overrule(Hit& hit);

}  // namespace tapfit::acquisition
