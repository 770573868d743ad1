// tapfit modes: the identified modes.
#pragma once

#include "tui/options/command.hpp"

#include <string>

namespace tapfit::tui {

/// Identifies with the options given. With --uff also writes the modes, with
/// --fit the synthesised FRFs, with --diagram prints the stabilisation diagram.
/// @throws InputError, Stopped
[[nodiscard]] std::string modes_command(const CommandOptions& options,
                                        const Progress& progress);

}  // namespace tapfit::tui
