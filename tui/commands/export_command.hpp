// tapfit export: FRFs and modes as universal file, the updated model as deck.
#pragma once

#include "acquisition/uff/uff_geometry.hpp"
#include "tui/options/command.hpp"
#include "updating/session/session.hpp"

namespace tapfit::tui {

/// --uff writes the measured FRFs and modes (datasets 58 and 55), --records the
/// recordings (58b, or 58 with --text), both with the grids and lines of the
/// model where there is one (2411, or 15 with --nodes 15, and 82); --deck the
/// bulk data with the cards of the effects named by --effect (without any:
/// those that the diagnosis supports).
///
/// @throws InputError when neither is asked for, when a file cannot be
///   written, for a deck where the bundle has none; Stopped
[[nodiscard]] std::string export_command(const CommandOptions& options,
                                         const Progress& progress);

/// FRFs (dataset 58) and modes (dataset 55) in one universal file.
/// @param nodes dataset of the model's grids
/// @throws InputError where it cannot be written; Stopped
void write_measured_uff(updating::Session& session,
                        const std::filesystem::path& path,
                        acquisition::UffNodes nodes,
                        const Progress& progress);

/// The deck that was read is the engineer's own: it is never written over. A
/// model given as matrices has none.
/// @throws InputError
void check_deck_path(updating::Session& session,
                     const std::filesystem::path& path);

}  // namespace tapfit::tui
