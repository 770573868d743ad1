// What pairs of FRFs that were measured both ways speak against.
#pragma once

#include "acquisition/bundle/test_bundle.hpp"
#include "acquisition/foundation/finding.hpp"
#include "signal/checks/frf_checks.hpp"

#include <vector>

namespace tapfit::signal {

/// Pairs that differ: by sign, by a factor or a constant alone, or in shape.
[[nodiscard]] std::vector<Finding> reciprocity_findings(
    const acquisition::TestBundle& bundle,
    const FrfSet& set,
    const std::vector<Reciprocal>& pairs);

}  // namespace tapfit::signal
