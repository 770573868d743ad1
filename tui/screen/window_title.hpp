// The title of the terminal's window, or of its tab.
//
// Source: Thomas E. Dickey, "XTerm Control Sequences": operating system command
// 2 sets it, window operations 22 and 23 put it aside and fetch it again.
#pragma once

#include <string>
#include <string_view>

namespace tapfit::tui {

/// @param kind as TERM names it, or null; what is no window, as the Linux
///   console, would show the letters
[[nodiscard]] bool has_window_title(const char* kind);

/// @param text control characters in it are left out
/// @param ascii what is no ASCII becomes what is like it
[[nodiscard]] std::string title_sequence(const std::string& text, bool ascii);

inline constexpr const char* put_title_aside = "\033[22;2t";
inline constexpr const char* fetch_title = "\033[23;2t";

}  // namespace tapfit::tui
