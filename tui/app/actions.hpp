// What the user asks for, as jobs for the worker.
#pragma once

#include "tui/workbench/worker.hpp"

#include <filesystem>
#include <string>
#include <utility>
#include <vector>

namespace tapfit::tui {

/// Hits as run and number, counted from 0.
[[nodiscard]] Job overrule_hits(
    const std::vector<std::pair<std::size_t, std::size_t>>& hits);
/// Takes the last overruling back, of all hits that it was of.
[[nodiscard]] Job restore_hits();
/// Redo of that, until another hit is overruled.
[[nodiscard]] Job overrule_again();
/// In this order, as one step.
[[nodiscard]] Job add_effects(const std::vector<updating::EffectRef>& effects);
/// As typed: "added-mass@201", or several, with spaces between.
[[nodiscard]] Job add_effects(const std::string& typed);
/// Switches an added effect off or on, counted from 0.
[[nodiscard]] Job toggle_effect(std::size_t effect);
/// @param replace over a file that is there
/// @param note what is told before where it was written
[[nodiscard]] Job write_output(Output what,
                               const std::filesystem::path& to,
                               bool replace,
                               const std::string& note = {});
[[nodiscard]] Job undo();
[[nodiscard]] Job redo();

}  // namespace tapfit::tui
