// Which graphics the terminal has, by asking it.
#pragma once

#include "tui/screen/pixel_picture.hpp"

#include <optional>
#include <string>
#include <string_view>

namespace tapfit::tui {

enum class Graphics { None, Kitty, Sixel };

/// What the user wants; Auto: what the terminal says it has.
enum class GraphicsWish { Auto, Kitty, Sixel, Off };

struct TerminalGraphics {
  bool kitty = false;
  bool sixel = false;
  CellPixels cell;    ///< none: not known
  std::string typed;  ///< meanwhile, by the user

  /// The better one of them, where cells are known.
  [[nodiscard]] Graphics best() const;
};

/// As options and settings name it; empty where there is none of that name.
[[nodiscard]] std::optional<GraphicsWish> graphics_wish(std::string_view word);

/// Takes at most 0.3 s. What the user has typed before is read with the answer.
/// @pre standard input and output are a terminal
/// @param kind as TERM names it
[[nodiscard]] TerminalGraphics ask_for_graphics(std::string_view kind);

/// Of the window as it is now; none where it does not tell.
[[nodiscard]] CellPixels cell_of_window();

}  // namespace tapfit::tui
