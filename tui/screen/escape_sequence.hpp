// What terminals send after an Esc that is not the key: keys that terminfo does
// not know, answers, pasted text.
#pragma once

#include "tui/screen/key.hpp"

#include <functional>
#include <optional>
#include <string>

namespace tapfit::tui {

struct EscapeSequence {
  bool is_one = false;     ///< else it was the key Esc
  std::optional<Key> key;  ///< that it stands for, where it is known
  std::u32string unread;   ///< belongs to what comes next
};

/// Takes a sequence whole, so that no part of it counts as typed.
/// @param next the next character, nothing where none is waiting
/// Source: ECMA-48, sections 5.3 to 5.6; xterm's keys.
[[nodiscard]] EscapeSequence read_escape_sequence(
    const std::function<std::optional<char32_t>()>& next);

}  // namespace tapfit::tui
