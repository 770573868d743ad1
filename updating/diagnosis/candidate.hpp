// What was fitted as it is listed: the effect that was looked for, its size and
// what it leaves.
#pragma once

#include "updating/diagnosis/diagnosis.hpp"
#include "updating/fit/fitter.hpp"

namespace tapfit::updating {

/// The fit's last effect; how probable it is no fit says by itself.
[[nodiscard]] Candidate candidate_of(const Fit& fit,
                                     const effects::TestContext& context);

/// What was tried so far, the least error first, with no verdict; what was
/// tried before takes the place of itself.
/// @param before of the same search; may be null
[[nodiscard]] Diagnosis with_tried(const Diagnosis* before,
                                   const Candidate& candidate);

}  // namespace tapfit::updating
