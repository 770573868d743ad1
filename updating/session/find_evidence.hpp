// What an effect does for the model of a test: the model is fitted without it,
// and with it where it is not there yet. The session's own stays as it is.
#pragma once

#include "updating/comparison/effect_evidence.hpp"
#include "updating/session/session_stages.hpp"

namespace tapfit::updating {

/// @param effect in the model, or among those added; uncertain_rung: what is
///   uncertain, before any effect is in the model
/// @param added put into the model first
/// @param stages with fits prepared
/// @throws InputError for an effect that has no such place; Stopped
[[nodiscard]] EffectEvidence find_evidence(SessionStages& stages,
                                           const EffectRef& effect,
                                           const std::vector<EffectRef>& added,
                                           const Progress& progress);

}  // namespace tapfit::updating
