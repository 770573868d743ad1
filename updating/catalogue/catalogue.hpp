// All effects the program knows, by name. A new effect is one file pair and one
// line here; screens, ranking, reports and export pick it up.
#pragma once

#include "updating/effects/effect.hpp"

#include <span>

namespace tapfit::effects {

/// In the order in which they are listed to users.
[[nodiscard]] std::span<const std::unique_ptr<const Effect>> catalogue();

/// @throws InputError naming the known effects when there is none of that name
[[nodiscard]] const Effect& find(const std::string& name);

}  // namespace tapfit::effects
