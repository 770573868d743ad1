// tapfit update: adds the effects named, in order, and identifies them.
#pragma once

#include "tui/options/command.hpp"
#include "updating/session/session.hpp"

namespace tapfit::tui {

/// What a session's ladder says, as a diagnosis of the effects that were
/// named: each is its own candidate, taken as given.
///
/// @param ladder base rung first
/// @param comparison its floor counts
/// @param held what else than the data holds the parameters: see
/// updating::held_back()
[[nodiscard]] updating::Diagnosis diagnosis_of_named(
    const std::vector<updating::Rung>& ladder,
    const updating::Comparison& comparison,
    const std::vector<updating::Estimate>& model_parameters,
    const std::vector<std::string>& held = {});

/// What --lines and --lambda ask for.
/// @throws InputError for lines that are none
[[nodiscard]] updating::UpdateChoice update_choice(
    const CommandOptions& options);

/// @throws InputError for an unknown effect or a place it cannot take; Stopped
[[nodiscard]] std::string update_command(const CommandOptions& options,
                                         const Progress& progress);

}  // namespace tapfit::tui
