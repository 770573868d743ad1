// What the user decides about the modes, as jobs for the worker. Each is kept
// with the session; undo_modes() takes the last one back.
#pragma once

#include "tui/workbench/worker.hpp"

#include <array>
#include <optional>
#include <string>

namespace tapfit::tui {

/// Takes the mode nearest to a frequency out [Hz].
[[nodiscard]] Job drop_mode(double hz);
/// Puts the steadiest pole of the diagram near a frequency in [Hz].
[[nodiscard]] Job add_mode(double hz);
/// Pairs a measured mode with one of the model, both counted from 0; -1: it has
/// no partner.
[[nodiscard]] Job pair_mode(std::size_t measured, int model);
/// Modes are sought between two frequencies [Hz]; none: in all lines.
[[nodiscard]] Job mode_band(const std::optional<std::array<double, 2>>& band);
[[nodiscard]] Job undo_modes();
[[nodiscard]] Job redo_modes();

/// As typed after ':', the word and what follows it: "drop 12.98",
/// "pick 12.98", "pair 2:3" or "pair 2:none" (counted from 1), "band 10 60",
/// "band all".
///
/// @throws InputError for what is none of these
[[nodiscard]] Job mode_action(const std::string& word,
                              const std::string& argument);

}  // namespace tapfit::tui
