// tapfit frf: the measured FRFs and how good they are.
#pragma once

#include "tui/options/command.hpp"

#include <string>

namespace tapfit::tui {

/// With --uff also writes the curves, in the form asked for; with --free the
/// sensors' masses are taken off first.
/// @throws InputError, Stopped
[[nodiscard]] std::string frf_command(const CommandOptions& options,
                                      const Progress& progress);

}  // namespace tapfit::tui
