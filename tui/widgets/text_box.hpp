// A box with lines of text in the middle of a screen.
#pragma once

#include "tui/screen/screen.hpp"

#include <string>
#include <vector>

namespace tapfit::tui {

/// Lines of text that such a box on a screen of that height has room for.
[[nodiscard]] int text_box_rows(int screen_height);

/// @param first the line that is shown first, where not all fit; arrows tell
///   that there are more above or below
void draw_text_box(Screen& screen,
                   const std::string& title,
                   const std::vector<std::string>& lines,
                   Style style,
                   int first = 0);

}  // namespace tapfit::tui
