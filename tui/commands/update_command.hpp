// tapfit update: adds the effects named, in order, and identifies them.
#pragma once

#include "tui/options/command.hpp"
#include "updating/session/session.hpp"

namespace tapfit::tui {

/// What --lines and --lambda ask for.
/// @throws InputError for lines that are none
[[nodiscard]] updating::UpdateChoice update_choice(
    const CommandOptions& options);

}  // namespace tapfit::tui
