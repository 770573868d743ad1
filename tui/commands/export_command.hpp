// tapfit export: FRFs and modes as universal file, the updated model as deck.
#pragma once

#include "tui/options/command.hpp"

#include <string>

namespace tapfit::tui {

/// --uff writes the measured FRFs and modes (datasets 58 and 55), --records the
/// recordings (58b, or 58 with --text), both with the grids and lines of the
/// model where there is one (2411, or 15 with --nodes 15, and 82); --deck the
/// bulk data with the cards of the effects named by --effect (without any:
/// those that the diagnosis supports); --vtu the shapes of the model with the
/// effects named, and those measured.
///
/// @throws InputError when neither is asked for, when a file cannot be
///   written, for a deck where the bundle has none; Stopped
[[nodiscard]] std::string export_command(const CommandOptions& options,
                                         const Progress& progress);

}  // namespace tapfit::tui
