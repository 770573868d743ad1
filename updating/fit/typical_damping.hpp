// The damping ratio that is typical of a structure, from a fit of its modes.
#pragma once

#include "updating/fit/updater.hpp"

namespace tapfit::updating {

/// What the structure's modes have without the effects that damp some of them
/// on top: of the modes fitted the middle one, each by the share of its prior's
/// variance that the data took off. Modes that show nowhere say nothing: where
/// none does it is what the fit assumed of the others.
[[nodiscard]] double typical_damping(const UpdateResult& result);

}  // namespace tapfit::updating
