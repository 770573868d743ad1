// `tapfit uff FILE`: what a universal file holds.
#pragma once

#include "tui/options/command.hpp"

namespace tapfit::tui {

/// Header, units, points, trace lines, elements, functions and shapes of a
/// universal file, and which datasets are not known.
///
/// @throws InputError for what is broken, with its place
[[nodiscard]] std::string uff_command(const CommandOptions& options,
                                      const Progress& progress);

}  // namespace tapfit::tui
