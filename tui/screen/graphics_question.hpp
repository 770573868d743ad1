// What a terminal is asked for its graphics, and its answers.
//
// Every terminal answers what it is (DA1), so that an answer to it tells that
// there is none to what was asked before: whether it knows kitty's graphics
// protocol, and how large its cells are.
//
// Sources: Kovid Goyal, "Terminal graphics protocol"; Thomas E. Dickey, "XTerm
// Control Sequences" (CSI c, CSI 16 t).
#pragma once

#include "tui/screen/pixel_picture.hpp"

#include <string>
#include <string_view>

namespace tapfit::tui {

/// @param kind as TERM names it; some kinds would print what they do not know,
///   or pass it on
/// @return empty where nothing should be asked
[[nodiscard]] std::string graphics_question(std::string_view kind);

struct GraphicsAnswer {
  bool complete = false;  ///< nothing is to come any more
  bool kitty = false;
  bool sixel = false;
  CellPixels cell;    ///< none: not told
  std::string typed;  ///< all that is no answer
};
/// @param bytes read so far
[[nodiscard]] GraphicsAnswer read_graphics_answer(std::string_view bytes);

}  // namespace tapfit::tui
