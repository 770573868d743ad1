// `tapfit check BUNDLE`: what is wrong with a test, before any model.
#pragma once

#include "tui/options/command.hpp"

namespace tapfit::tui {

/// Findings with their remedies; below them what each channel recorded,
/// coherence of sensors x hits, driving points, reciprocity, lowest lines, H1
/// against H2 at the peaks.
///
/// @throws InputError where test.json itself cannot be read; Stopped
[[nodiscard]] std::string check_command(const CommandOptions& options,
                                        const Progress& progress);

}  // namespace tapfit::tui
