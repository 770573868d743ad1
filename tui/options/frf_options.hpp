// Options of how FRFs are estimated, and which sensors' masses are taken off.
#pragma once

#include "tui/options/command.hpp"

#include <CLI/CLI.hpp>

namespace tapfit::tui {

/// --estimator, --form, --window, --sigma and --best-hits.
void add_estimate(CLI::App& command, FrfArguments& frf);

/// --free, as often as is wanted.
void add_free_masses(CLI::App& command, CommandOptions& options);

}  // namespace tapfit::tui
