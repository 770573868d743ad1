// All effects the program knows, by name; screens, ranking, reports and export
// pick them up.
#pragma once

#include "updating/effects/effect.hpp"

#include <span>

namespace tapfit::effects {

/// In the order in which they are listed to users.
[[nodiscard]] std::span<const Effect* const> catalogue();

/// @throws InputError naming the known effects when there is none of that name
[[nodiscard]] const Effect& find(const std::string& name);

}  // namespace tapfit::effects
