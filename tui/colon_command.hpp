// What is typed after ':'.
#pragma once

#include <string>
#include <string_view>

namespace tapfit::tui {

struct ColonCommand {
  enum class Kind { Quit, Help, Add, Toggle, Undo, Redo, Screen, Stop, Retry };
  Kind kind = Kind::Help;
  std::string argument;    ///< the effect of Add
  std::size_t number = 0;  ///< 1..7 of Screen; effect of Toggle, from 1
};

/// "q", "help", "add added-mass@201", "toggle 2", "undo", "redo", "screen 3",
/// "3", "stop", "retry"; a name may be cut short while it is clear ("sc 3").
///
/// @throws InputError for what is none of these
[[nodiscard]] ColonCommand parse_colon_command(std::string_view text);

}  // namespace tapfit::tui
