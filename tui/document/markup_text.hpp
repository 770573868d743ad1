// Text inside HTML and SVG.
#pragma once

#include <string>
#include <string_view>

namespace tapfit::tui {

/// & < > " ' as entities; control characters, which neither allows, as spaces.
[[nodiscard]] std::string escaped(std::string_view text);

}  // namespace tapfit::tui
