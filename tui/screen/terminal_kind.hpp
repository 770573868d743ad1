// Kinds of terminals in terminfo's list, without opening one.
#pragma once

namespace tapfit::tui {

/// @param kind null: that of the environment variable TERM
[[nodiscard]] bool is_known_terminal(const char* kind);

}  // namespace tapfit::tui
