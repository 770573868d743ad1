// Channels whose delay against the hammer changes from hit to hit of one
// placement: told by channel and hit, with what to leave out. Where all sensors
// change alike it is the hammer's channel.
#pragma once

#include "acquisition/bundle/test_bundle.hpp"
#include "acquisition/foundation/finding.hpp"
#include "acquisition/hits/hits.hpp"
#include "signal/checks/delay_steps.hpp"
#include "signal/checks/group_spectra.hpp"

#include <vector>

namespace tapfit::signal {

struct DelayChanges {
  std::vector<Finding> findings;
  /// Hits that have another delay than most of their placement on some channel,
  /// in order; what else is odd of them comes from that.
  std::vector<HitAt> hits;
};

/// @param hits of the whole bundle, as the spectra were made of them
[[nodiscard]] DelayChanges delay_changes(const acquisition::TestBundle& bundle,
                                         const acquisition::HitSet& hits,
                                         const GroupSpectra& of,
                                         const DelayStepLimits& limits = {});

}  // namespace tapfit::signal
