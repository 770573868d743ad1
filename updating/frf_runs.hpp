// Runs and channels for a test that consists of ready FRFs.
#pragma once

#include "acquisition/test_bundle.hpp"
#include "signal/frf_set.hpp"

namespace tapfit::updating {

/// Gives a test without recordings a run for each reference point, a channel
/// "hammer" and one for each response point, "12Z". Universal files do not say
/// which sensor was where: each response point counts as a sensor that stayed,
/// which is said among the set's statements.
///
/// @param set its FRFs get their run and channel
void lay_out_runs(signal::FrfSet& set, acquisition::TestBundle& bundle);

}  // namespace tapfit::updating
