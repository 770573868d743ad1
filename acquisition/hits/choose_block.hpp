// Groups pulses into hits and chooses one block length for all of them.
#pragma once

#include "acquisition/hits/hammer_pulses.hpp"
#include "acquisition/hits/hits.hpp"
#include "acquisition/samples/octave_decay.hpp"

#include <optional>
#include <string>
#include <vector>

namespace tapfit::acquisition {

/// Pulses that belong to one hit: the blow and what bounced after it.
struct PulseGroup {
  Pulse first;            ///< the trigger belongs to it
  Pulse largest;          ///< the main pulse
  Eigen::Index room = 0;  ///< samples from the trigger to the next group or end
  bool ends_file = false;  ///< no group follows
};

struct RunPulses {
  std::vector<Pulse> pulses;
  Eigen::Index samples = 0;  ///< length of the record
};

/// Time within which a second pulse is a bounce and no new hit [samples]: a
/// fifth of the usual time between deliberate hits, which are taken to be half
/// a second apart or more; the block when its length is given.
[[nodiscard]] Eigen::Index choose_hold_off(const std::vector<RunPulses>& runs,
                                           double sample_rate_hz,
                                           const HitOptions& options);

[[nodiscard]] std::vector<PulseGroup> group_pulses(const RunPulses& run,
                                                   Eigen::Index hold_off);

struct Block {
  Eigen::Index samples = 0;
  Eigen::Index pre_trigger = 0;
  std::string reason;  ///< what limited the length
  ResponseDecay decay;
};

/// One block length for all hits.
///
/// The room after a trigger ends before the next hit or with the file. The
/// block fits into the smallest room, unless at most a fifth of the hits have
/// much less room than the rest (then those are given up, but never all hits
/// of a run); it is cut where the response has died away: lost in its noise,
/// and decayed by six time constants in every octave. Its length has only the
/// prime factors 2, 3, 5 and 7. A length that was asked for is kept, unless it
/// does not hold the pre-trigger and a pulse: the reason says so then.
///
/// @param lasting samples until the response is lost in its noise
/// @param slowest decay in any octave; empty where none is seen
/// @param pulse_width usual width of a pulse [samples]
/// @param least samples that the band needs for its resolution
struct BlockNeeds {
  Eigen::Index lasting = 0;
  std::optional<OctaveDecay> slowest;
  Eigen::Index least = 0;
  double pulse_width = 1.0;
  double sample_rate_hz = 1.0;
};
[[nodiscard]] Block choose_block(
    const std::vector<std::vector<PulseGroup>>& runs,
    const BlockNeeds& needs,
    const HitOptions& options);

/// The largest even number up to n with no prime factor above 7; n >= 2.
[[nodiscard]] Eigen::Index smooth_length(Eigen::Index n);

/// Samples after the trigger until a response is lost in its noise: the last of
/// 64 windows whose RMS exceeds 1.5 times that of the quietest window and a
/// thousandth of the strongest. All of them when it falls by less than 20 dB.
///
/// @param response one channel from the trigger to the end of the room
[[nodiscard]] Eigen::Index response_length(const Eigen::VectorXd& response);

}  // namespace tapfit::acquisition
