#include "tui/screen/clipboard.hpp"

#include "tui/screen/base64.hpp"

namespace tapfit::tui {

std::string clipboard_sequence(std::string_view text) {
  return "\033]52;c;" + base64(text) + "\a";
}

}  // namespace tapfit::tui
