// The room tui/paper. The tables of the paper whose method this program
// implements, beside the program's own results.
// In:  Bundles of the three structures.
// Out: Text.
// May include: its row in CONTRIBUTING.md.
//
// tapfit paper: the tables of the paper whose method this program implements,
// with its own results beside them.
#pragma once

#include "tui/options/command.hpp"

#include <CLI/CLI.hpp>

namespace tapfit::tui {

/// All structures, or those named. `options.input` is the folder that holds
/// the bundles paper-truss, paper-solar-wing and solar-panel-frame.
/// @throws InputError, Stopped
[[nodiscard]] std::string paper_command(const CommandOptions& options,
                                        const Progress& progress);

void add_paper_options(CLI::App& command, CommandOptions& options);

}  // namespace tapfit::tui
