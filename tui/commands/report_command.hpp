// tapfit report: the finished work as one Markdown document.
#pragma once

#include "tui/options/command.hpp"
#include "updating/comparison/comparison.hpp"
#include "updating/diagnosis/diagnosis.hpp"

namespace tapfit::tui {

/// Measured frequency against the model's before and after, MAC before and
/// after, as a Markdown table; one row per measured mode that either model
/// pairs.
[[nodiscard]] std::string before_after_table(const updating::Comparison& before,
                                             const updating::Comparison& after);

/// Runs the chain, adds every rung of the diagnosis, and writes the report to
/// --output or returns it.
///
/// @throws InputError, Stopped
[[nodiscard]] std::string report_command(const CommandOptions& options,
                                         const Progress& progress);

}  // namespace tapfit::tui
