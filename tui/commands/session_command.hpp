// tapfit session: does again, without a terminal, what was saved while a test
// was worked on, and compares what comes out with what came out then.
#pragma once

#include "tui/options/command.hpp"
#include "updating/session/saved_session.hpp"

namespace tapfit::tui {

/// Rungs with error, mean frequency error and mean MAC of the paired modes.
[[nodiscard]] std::string session_text(const updating::SavedSession& session);

/// What differs in the errors of two ladders by more than a millionth of
/// themselves; empty where nothing does.
[[nodiscard]] std::string differences(const updating::SavedSession& then,
                                      const updating::SavedSession& now);

/// @throws InputError for a missing or damaged session, Stopped
[[nodiscard]] std::string session_command(const CommandOptions& options,
                                          const Progress& progress);

}  // namespace tapfit::tui
