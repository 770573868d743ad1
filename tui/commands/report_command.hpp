// tapfit report: the finished work as one document.
#pragma once

#include "tui/options/command.hpp"

namespace tapfit::tui {

/// Takes up what was done in the terminal, where anything was; where no effect
/// was added there, runs the chain and adds every rung of the diagnosis. Writes
/// the report to --output, or to report.html beside the bundle's session.json.
///
/// @throws InputError, Stopped
[[nodiscard]] std::string report_command(const CommandOptions& options,
                                         const Progress& progress);

}  // namespace tapfit::tui
