// Looks for words on a screen or in a text.
#pragma once

#include "tui/screen/screen.hpp"

#include <string>

namespace tapfit::tui {

inline bool holds(const std::string& text, const std::string& part) {
  return text.find(part) != std::string::npos;
}

inline bool holds(const Screen& screen, const std::string& part) {
  return holds(screen.to_text(), part);
}

}  // namespace tapfit::tui
