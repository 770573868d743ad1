// The room tui/together. Several tests fitted at once.
// In:  The command line: bundles, and what they share.
// Out: What they say together, and whether they agree, as text and JSON.
// May include: its row in CONTRIBUTING.md.
#pragma once

#include "tui/options/command.hpp"

#include <string>

namespace tapfit::tui {

/// What several tests say of what they share, and whether they agree.
[[nodiscard]] std::string together_command(const CommandOptions& options,
                                           const Progress& progress);

}  // namespace tapfit::tui
