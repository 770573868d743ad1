// `tapfit replay BUNDLE`: the test as if it were being measured.
#pragma once

#include "tui/options/command.hpp"

namespace tapfit::tui {

/// Streams the recordings with bounded memory; each hit is shown on standard
/// error when its block is complete. The FRFs as `tapfit frf` has them.
///
/// @throws InputError, Stopped
[[nodiscard]] std::string replay_command(const CommandOptions& options,
                                         const Progress& progress);

}  // namespace tapfit::tui
