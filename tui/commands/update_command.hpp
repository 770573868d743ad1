// tapfit update: adds the effects named, in order, and identifies them.
#pragma once

#include "tui/options/command.hpp"
#include "updating/session/session.hpp"

namespace tapfit::tui {

/// What --lines and --lambda ask for.
/// @throws InputError for lines that are none
[[nodiscard]] updating::UpdateChoice update_choice(
    const CommandOptions& options);

/// @throws InputError for an unknown effect or a place it cannot take; Stopped
[[nodiscard]] std::string update_command(const CommandOptions& options,
                                         const Progress& progress);

}  // namespace tapfit::tui
