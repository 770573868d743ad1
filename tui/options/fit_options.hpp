// Options of what is identified, and how.
#pragma once

#include "tui/options/command.hpp"

#include <CLI/CLI.hpp>

namespace tapfit::tui {

/// --effect, as often as is wanted.
void add_effects(CLI::App& command, CommandOptions& options);

/// --lines and --lambda.
void add_regularisation(CLI::App& command, CommandOptions& options);

}  // namespace tapfit::tui
