// Two screens at once: beside each other where both are 80 columns wide, else
// one above the other where both have the rows of a screen of 24.
#pragma once

#include "tui/screen/layout.hpp"

#include <optional>

namespace tapfit::tui {

inline constexpr int least_width = 80;   ///< of a screen [cells]
inline constexpr int least_height = 24;  ///< with tabs and two lines below
inline constexpr int frame_rows = 3;     ///< these

struct Panes {
  Rect first;
  Rect second;
  Rect line;  ///< between them
  bool beside = true;
};

/// @param width, height of what is between tabs and the lines below [cells]
/// @return empty where there is too little room
[[nodiscard]] std::optional<Panes> split_panes(int width, int height);

}  // namespace tapfit::tui
