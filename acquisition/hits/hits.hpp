// Hits found in the hammer channel, and what is thought of each.
#pragma once

#include "acquisition/bundle/recording.hpp"
#include "acquisition/foundation/finding.hpp"
#include "acquisition/hits/hammer_saturation.hpp"

#include <optional>
#include <string>
#include <vector>

namespace tapfit::acquisition {

enum class HitFault {
  Double,
  Overload,
  Weak,
  Soft,
  Truncated,
  Outlier,
  ByHand
};

/// "double", "overload", "weak", "soft", "truncated", "outlier", "by hand".
[[nodiscard]] std::string name(HitFault fault);

struct Hit {
  Eigen::Index begin = 0;    ///< first sample of the block (pre-trigger in it)
  Eigen::Index trigger = 0;  ///< sample where the trigger level was crossed
  double time_s = 0.0;       ///< of the force's peak, from the file's start
  double peak_n = 0.0;       ///< magnitude, whatever the channel's polarity
  double pulse_s = 0.0;      ///< width of the main pulse
  bool accepted = true;
  /// What speaks against it; empty when good. An accepted hit has reasons when
  /// it was overruled, or kept as the best of a bad run.
  std::vector<HitFault> reasons;
};

struct HitSet {
  double sample_rate_hz = 0.0;
  Eigen::Index block = 0;        ///< samples per block, the same for all hits
  Eigen::Index pre_trigger = 0;  ///< samples of the block before the trigger
  std::string block_reason;      ///< why the block is as long as that
  Eigen::Index hold_off = 0;     ///< samples; a later pulse is a new hit
  double trigger_n = 0.0;        ///< lowest level used in any run [N]
  double usable_bandwidth_hz = 0.0;    ///< up to where a hit must not be soft
  std::vector<std::vector<Hit>> runs;  ///< as TestBundle::runs
  /// Per run the hammer's ceiling, where hits at it are judged out.
  std::vector<std::optional<HammerSaturation>> ceilings;
  std::vector<std::string> statements;  ///< what was chosen, and why
  /// Those of the statements that whoever sees FRFs or modes only must know,
  /// too: something in the recording or in test.json wants to be set right.
  std::vector<Finding> findings;
};

struct HitOptions {
  std::optional<double> trigger_percent;  ///< of the largest peak
  std::optional<double> trigger_n;        ///< the level itself [N]
  TriggerOptions trigger;
  std::optional<double> pre_trigger_s;
  std::optional<double> block_s;
  double double_hit_percent = 5.0;  ///< second peak, of the main one
};

/// Judges a hit out for a reason, which is noted once.
void reject(Hit& hit, HitFault fault);

/// Turns a hit's acceptance over by hand and notes HitFault::ByHand; a second
/// time takes both back. A truncated hit stays out: its block is not all there.
void overrule(Hit& hit);

}  // namespace tapfit::acquisition
