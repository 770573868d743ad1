// What kind of terminal it is, by way of terminfo (included here only).
#pragma once

#include "tui/screen/terminal_graphics.hpp"

#include <string>

namespace tapfit::tui {

/// What is known of the terminal without showing anything on it.
struct TerminalTraits {
  bool is_one = false;  ///< standard input and output are one
  std::string kind;     ///< of the environment variable TERM
  bool known = false;   ///< to terminfo
  bool places_cursor = false;
  int colours = 0;
  bool mouse = false;
  int width = 0;  ///< [cells], 0 where it does not say
  int height = 0;
  TerminalGraphics graphics;  ///< nothing where keys wait that were typed
};
[[nodiscard]] TerminalTraits look_at_terminal();

/// Whether terminfo has a kind, without opening a screen of it.
/// @param kind null: that of the environment variable TERM
[[nodiscard]] bool is_known_terminal(const char* kind);

}  // namespace tapfit::tui
