// Decisions made by hand, on the command line or kept in the session's file:
// hits, the modes' band, poles dropped and added, pairs.
#pragma once

#include "tui/options/command.hpp"
#include "updating/session/session.hpp"

#include <CLI/CLI.hpp>

namespace tapfit::tui {

void add_mode_choices(CLI::App& command, HandChoices& by_hand);
/// --pair, for commands that pair modes with the model's.
void add_pair_choices(CLI::App& command, HandChoices& by_hand);

/// The bundle of a command with what was decided by hand: nothing but what the
/// command line says, or that on top of the session's file. Kept decisions that
/// are left aside are mentioned on standard error; added effects are never
/// taken over.
///
/// @throws InputError also for a mode to be paired that is not there
[[nodiscard]] updating::Session open_by_hand(const CommandOptions& options,
                                             const Progress& progress);

/// The same with all that the session's file keeps, added effects too, and
/// beneath what the command line says.
[[nodiscard]] updating::Session open_as_kept(const CommandOptions& options,
                                             const Progress& progress);

}  // namespace tapfit::tui
