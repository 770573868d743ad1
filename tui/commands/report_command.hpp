// tapfit report: the finished work as one Markdown document.
#pragma once

#include "tui/options/command.hpp"
#include "updating/comparison/comparison.hpp"
#include "updating/diagnosis/diagnosis.hpp"

namespace tapfit::tui {

/// Runs the chain, adds every rung of the diagnosis, and writes the report to
/// --output or returns it.
///
/// @throws InputError, Stopped
[[nodiscard]] std::string report_command(const CommandOptions& options,
                                         const Progress& progress);

}  // namespace tapfit::tui
