// What a command that reads its own command line answers where there is nothing
// to be done.
#pragma once

#include <CLI/CLI.hpp>

namespace tapfit::tui {

/// Prints the help that was asked for, or says what is wrong.
/// @return exit status: 0 for help, 2 where the command line is at fault
[[nodiscard]] int answer(const CLI::App& app, const CLI::ParseError& error);

}  // namespace tapfit::tui
