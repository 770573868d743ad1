// The clipboard of whoever sits at the terminal, also at the other end of ssh.
//
// Source: Thomas E. Dickey, "XTerm Control Sequences", operating system command
// 52.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>

namespace tapfit::tui {

/// Bytes of text that terminals take: tmux a megabyte as it is written.
inline constexpr std::size_t most_copied = 780'000;

/// What a terminal is sent so that the text is in its clipboard.
[[nodiscard]] std::string clipboard_sequence(std::string_view text);

}  // namespace tapfit::tui
