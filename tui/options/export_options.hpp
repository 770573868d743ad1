// What `tapfit export` can be told to write, besides FRFs and modes.
#pragma once

#include "tui/options/command.hpp"

#include <CLI/CLI.hpp>

namespace tapfit::tui {

void add_export_options(CLI::App& command, CommandOptions& options);

}  // namespace tapfit::tui
