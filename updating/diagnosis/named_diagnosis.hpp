// The diagnosis that an engineer makes by naming effects.
#pragma once

#include "updating/comparison/comparison.hpp"
#include "updating/diagnosis/diagnosis.hpp"

#include <string>
#include <vector>

namespace tapfit::updating {

/// What a session's ladder says, as a diagnosis of the effects that were
/// named: each is its own candidate, taken as given.
///
/// @param ladder base rung first
/// @param comparison its floor counts
/// @param held what else than the data holds the parameters: see
/// active_constraints()
[[nodiscard]] Diagnosis diagnosis_of_named(
    const std::vector<Rung>& ladder,
    const Comparison& comparison,
    const std::vector<Estimate>& model_parameters,
    const std::vector<std::string>& held = {});

}  // namespace tapfit::updating
