// Runs and channels for a test that consists of ready FRFs.
#pragma once

#include "acquisition/bundle/test_bundle.hpp"
#include "signal/frf_set/frf_set.hpp"

namespace tapfit::updating {

/// What a file of ready FRFs does not say.
enum class Sensors {
  Stayed,  ///< one for each response point, all there all the time
  Moved,   ///< one for each direction, moved from grid to grid
};

/// Gives a test without recordings its runs and channels: "hammer" and, for
/// sensors that stayed, a run for each reference point and a channel for each
/// response point, "12Z"; for sensors that moved, a run for each reference
/// point and place and a channel for each direction, "sensor Z".
///
/// @param set its FRFs get their run and channel
void lay_out_runs(signal::FrfSet& set,
                  acquisition::TestBundle& bundle,
                  Sensors sensors);

}  // namespace tapfit::updating
