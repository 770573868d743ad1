// What the user asks for, as jobs for the worker.
#pragma once

#include "tui/worker.hpp"

#include <string>

namespace tapfit::tui {

[[nodiscard]] Job overrule_hit(std::size_t run, std::size_t hit);
/// Takes the last overruling back.
[[nodiscard]] Job restore_hit();
[[nodiscard]] Job add_effect(const updating::EffectRef& effect);
/// As typed: "added-mass@201".
[[nodiscard]] Job add_effect(const std::string& effect);
/// Switches an added effect off or on, counted from 0.
[[nodiscard]] Job toggle_effect(std::size_t effect);
[[nodiscard]] Job undo();
[[nodiscard]] Job redo();

}  // namespace tapfit::tui
