// The steps from a run's hammer channel to judged hits, for one that is in
// memory as a whole and for one that is replayed piece by piece.
#pragma once

#include "acquisition/hits/choose_block.hpp"
#include "acquisition/hits/hammer_pulses.hpp"
#include "acquisition/hits/hits.hpp"

#include <optional>
#include <vector>

namespace tapfit::acquisition {

inline constexpr double default_trigger = 0.05;  ///< of the largest peak

/// Of the trigger's level, where it is armed again.
[[nodiscard]] double rearm_share(const HitOptions& options);

/// One run on its way through the steps.
struct HammerRun {
  HammerSignal hammer;
  double level = 0.0;  ///< of the trigger [N]
  RunPulses pulses;
  std::vector<PulseGroup> groups;
};

/// The hammer's channel made ready; no pulses yet.
///
/// @param slope 1 or -1 where it is known which way blows go in the file
[[nodiscard]] HammerRun prepare_run(const Run& run,
                                    const Recording& recording,
                                    std::optional<int> slope);

/// The median width of all runs' pulses [samples].
[[nodiscard]] double usual_width(const std::vector<HammerRun>& runs);

/// Upper end of the band; 0.4 of the sampling rate without one [Hz].
[[nodiscard]] double band_end(const TestBundle& bundle, double rate);

/// Up to where a hit must not be soft [Hz]: the end of the bundle's band. When
/// none is given nobody asked for more than the hammer's tip excites: where the
/// usual hit's force has fallen by 10 dB, at most 0.4 of the rate. A hit is
/// then soft when its force falls by 20 dB before 0.9 of that.
[[nodiscard]] double usable_bandwidth(const TestBundle& bundle,
                                      const std::vector<HammerRun>& runs,
                                      double rate);

/// The run's groups as hits, with everything that can be told from each alone:
/// double, overload, too little over the noise, soft, truncated.
///
/// @param set says block and pre-trigger
[[nodiscard]] std::vector<Hit> judge_alone(const TestBundle& bundle,
                                           const Run& run,
                                           const Recording& recording,
                                           const HammerRun& work,
                                           const HitSet& set,
                                           double double_percent);

}  // namespace tapfit::acquisition
