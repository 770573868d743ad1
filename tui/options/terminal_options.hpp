// The options of the terminal program itself.
#pragma once

#include "tui/options/app_options.hpp"

#include <CLI/CLI.hpp>

#include <filesystem>

namespace tapfit::tui {

/// BUNDLE and everything that says how it is shown.
void add_terminal_options(CLI::App& app,
                          std::filesystem::path& bundle,
                          AppOptions& options);

}  // namespace tapfit::tui
