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

/// The largest blow beside the main one in a hit's block, and what all such
/// blows cost.
struct SecondPulse {
  double share = 0.0;         ///< its height, of the main pulse's
  double after_s = 0.0;       ///< behind the main pulse; negative: before it
  double loss_db = 0.0;       ///< how much deeper the force falls in the band
  double outside = 0.0;       ///< share of the response behind the block's end
  bool thins_force = false;   ///< loss_db leaves too little force at some line
  bool leaves_block = false;  ///< `outside` is too much
};

/// How responses die away.
struct ResponseDecay {
  double rate = 0.0;         ///< of the slowest octave [1/s]; 0: none is seen
  Eigen::Index lasting = 0;  ///< samples until all is lost in noise
};

struct Hit {
  Eigen::Index begin = 0;    ///< first sample of the block (pre-trigger in it)
  Eigen::Index trigger = 0;  ///< sample where the trigger level was crossed
  double time_s = 0.0;       ///< of the force's peak, from the file's start
  double peak_n = 0.0;       ///< magnitude, whatever the channel's polarity
  double pulse_s = 0.0;      ///< width of the main pulse
  /// Samples before and behind the trigger within which all of the block's
  /// blows lie; both 0 where there is only the main one.
  Eigen::Index blows_before = 0;
  Eigen::Index blows_after = 0;
  std::optional<SecondPulse> second;  ///< where there is another blow
  bool accepted = true;
  /// What speaks against it; empty when good. An accepted hit has reasons when
  /// it was overruled, or kept as the best of a bad run, or is a double one
  /// that costs little.
  std::vector<HitFault> reasons;
};

struct HitSet {
  double sample_rate_hz = 0.0;
  Eigen::Index block = 0;        ///< samples per block, the same for all hits
  Eigen::Index pre_trigger = 0;  ///< samples of the block before the trigger
  std::string block_reason;      ///< why the block is as long as that
  ResponseDecay decay;           ///< of all runs the slowest
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

/// Notes what speaks against a hit, once.
void note(Hit& hit, HitFault fault);

/// Judges a hit out for a reason, which is noted once.
void reject(Hit& hit, HitFault fault);

/// Turns a hit's acceptance over by hand and notes HitFault::ByHand; a second
/// time takes both back. A truncated hit stays out: its block is not all there.
void overrule(Hit& hit);

}  // namespace tapfit::acquisition
