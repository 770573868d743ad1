// Where effects may sit, as it is typed behind the '@'.
#pragma once

#include "updating/effects/effect.hpp"

#include <string>
#include <string_view>
#include <vector>

namespace tapfit::tui {

/// What the place may be going on to: grids of the model, elements, channels,
/// "rotation", "201:rotary"; of a list joined with ':' the last one.
///
/// @param context the model may be missing: there are no grids then
/// @param typed so far, behind the '@'
[[nodiscard]] std::vector<std::string> place_words(
    const effects::Effect& effect,
    const effects::TestContext& context,
    std::string_view typed);

}  // namespace tapfit::tui
