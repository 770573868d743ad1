// The room tui/commands. The command line: one file per command, all through
// one table.
// In:  argv.
// Out: What a command prints.
// May include: its row in CONTRIBUTING.md.
//
// The command line: which command, with which options.
#pragma once

#include "acquisition/foundation/progress.hpp"
#include "tui/options/app_options.hpp"
#include "tui/options/command.hpp"

#include <string>
#include <variant>
#include <vector>

namespace tapfit::tui {

/// A command that reads its own command line, its name first, and prints.
/// @return exit status
using OwnCommand = int (*)(int argc,
                           const char* const* argv,
                           const Progress& progress);

/// What the user asked for.
struct Invocation {
  std::string name;           ///< "hits" and so on; empty: open the terminal
  Command command = nullptr;  ///< null for the terminal and own commands
  OwnCommand own = nullptr;   ///< "simulate" and its like
  CommandOptions options;
  AppOptions app;
  std::vector<std::string> passed_on;  ///< arguments of an own command
  /// What to print where neither command nor bundle is named and there is no
  /// terminal to pick one in; empty where something is.
  std::string help;
};

/// Nothing to be done but to print: help and version were asked for, or the
/// command line is at fault.
struct CommandLineAnswer {
  int exit_status = 0;  ///< 0 for help and version, 2 for a fault
  std::string text;     ///< for standard output (0) or standard error (2)
};

/// @param argv as main() gets it, the program's name first
[[nodiscard]] std::variant<Invocation, CommandLineAnswer> parse_command_line(
    int argc, const char* const* argv);

/// Names of all commands, in the order of the work.
[[nodiscard]] std::vector<std::string> command_names();

}  // namespace tapfit::tui
