// What cannot be asked of a test that consists of modes.
#pragma once

#include "updating/effects/effect_ref.hpp"
#include "updating/fit/update_choice.hpp"
#include "updating/session/saved_session.hpp"

#include <vector>

namespace tapfit::updating {

/// @throws InputError for an effect that undamped modes do not tell of
void check_shown_in_modes(const std::vector<EffectRef>& effects);

/// @throws InputError for a session with such an effect, on, off or undone: it
///   was saved when the test consisted of FRFs or recordings
void check_saved_shown_in_modes(const SavedSession& saved);

/// @throws InputError for a choice of lines or of lambda: there are no lines
void check_choice_for_modes(const UpdateChoice& choice);

}  // namespace tapfit::updating
