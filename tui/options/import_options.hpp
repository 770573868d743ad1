// Options of `tapfit import`.
#pragma once

#include "tui/options/command.hpp"

#include <CLI/CLI.hpp>

namespace tapfit::tui {

void add_import_options(CLI::App& command, CommandOptions& options);

}  // namespace tapfit::tui
