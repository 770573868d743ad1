// tapfit hits: the hits found in each run, and what is thought of each.
#pragma once

#include "tui/options/command.hpp"

#include <string>

namespace tapfit::tui {

/// @throws InputError, Stopped
[[nodiscard]] std::string hits_command(const CommandOptions& options,
                                       const Progress& progress);

}  // namespace tapfit::tui
