// The options of the terminal program itself.
#pragma once

#include "tui/commands/command_line.hpp"

#include <CLI/CLI.hpp>

namespace tapfit::tui {

/// BUNDLE and everything that says how it is shown.
void add_terminal_options(CLI::App& app, Invocation& invocation);

}  // namespace tapfit::tui
