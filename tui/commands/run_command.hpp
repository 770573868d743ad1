// tapfit run: the whole chain, from recording to error ladder.
#pragma once

#include "tui/options/command.hpp"

namespace tapfit::tui {

/// Text ends with the error ladder; JSON is {"hits", "frf", "modes",
/// "compare", "diagnose"}. Without a model the last two are null and the text
/// ends with the modes.
///
/// @throws InputError, Stopped
[[nodiscard]] std::string run_command(const CommandOptions& options,
                                      const Progress& progress);

}  // namespace tapfit::tui
