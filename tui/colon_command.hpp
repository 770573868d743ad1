// What is typed after ':'.
#pragma once

#include <string>
#include <string_view>

namespace tapfit::tui {

struct ColonCommand {
  enum class Kind {
    Quit,
    Help,
    Add,
    Toggle,
    Undo,
    Redo,
    Drop,  ///< this and the next three as of mode_action()
    Pick,
    Pair,
    Band,
    Screen,
    Stop,
    Retry,
  };
  Kind kind = Kind::Help;
  std::string argument;    ///< the effect of Add; what follows Drop to Band
  std::size_t number = 0;  ///< 1..7 of Screen; effect of Toggle, from 1
};

/// "q", "help", "add added-mass@201", "toggle 2", "undo", "redo", "screen 3",
/// "3", "stop", "retry", "drop 12.98", "pick 12.98", "pair 2:3", "band 10 60";
/// a name may be cut short while it is clear ("sc 3").
///
/// @throws InputError for what is none of these
[[nodiscard]] ColonCommand parse_colon_command(std::string_view text);

}  // namespace tapfit::tui
