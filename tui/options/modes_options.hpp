// What `tapfit modes` can be told about the identification.
#pragma once

#include "tui/options/command.hpp"

#include <CLI/CLI.hpp>

namespace tapfit::tui {

void add_modes_options(CLI::App& command, ModesArguments& arguments);

}  // namespace tapfit::tui
