#include "tui/screen/window_title.hpp"

#include "acquisition/foundation/utf8.hpp"
#include "tui/screen/text.hpp"

#include <algorithm>
#include <array>

namespace tapfit::tui {

bool has_window_title(const char* kind) {
  constexpr std::array<std::string_view, 9> windows{"xterm",
                                                    "tmux",
                                                    "screen",
                                                    "rxvt",
                                                    "vte",
                                                    "gnome",
                                                    "konsole",
                                                    "alacritty",
                                                    "foot"};
  const std::string_view own = kind != nullptr ? kind : "";
  return std::ranges::any_of(
      windows, [own](std::string_view name) { return own.starts_with(name); });
}

std::string title_sequence(const std::string& text, bool ascii) {
  std::string title = acquisition::printable(ascii ? to_ascii(text) : text);
  std::erase_if(title, [](unsigned char c) { return c < ' ' || c == 0x7F; });
  return "\033]2;" + title + "\a";
}

}  // namespace tapfit::tui
