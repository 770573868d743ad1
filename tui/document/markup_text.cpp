#include "tui/document/markup_text.hpp"

#include "acquisition/foundation/utf8.hpp"

namespace tapfit::tui {

std::string escaped(std::string_view text) {
  std::string out;
  out.reserve(text.size());
  for (const char c : acquisition::printable(text)) {
    switch (c) {
      case '&':
        out += "&amp;";
        break;
      case '<':
        out += "&lt;";
        break;
      case '>':
        out += "&gt;";
        break;
      case '"':
        out += "&quot;";
        break;
      case '\'':
        out += "&#39;";
        break;
      default:
        out += c == '\n' || c == '\t' ? ' ' : c;
    }
  }
  return out;
}

}  // namespace tapfit::tui
