// Each run's modal constants against those of the other runs. While the sensors
// stay, what one sensor shows of a mode over what the others show is the same
// whatever point is hit:
//
//   z_rck = phi_ck q_rk
//
// A sensor whose range was changed in a run is off by one factor in all modes,
// one that was moved by another factor in each.
#pragma once

#include "acquisition/bundle/test_bundle.hpp"
#include "acquisition/foundation/finding.hpp"
#include "modal/checks/sensor_patterns.hpp"
#include "modal/mode_set/mode_set.hpp"
#include "signal/frf_set/frf_set.hpp"

#include <vector>

namespace tapfit::modal {

/// @return one finding for each change, with the runs that share it
[[nodiscard]] std::vector<Finding> run_residue_findings(
    const acquisition::TestBundle& bundle,
    const signal::FrfSet& set,
    const ModeSet& modes,
    const RunResidueLimits& limits = {});

}  // namespace tapfit::modal
