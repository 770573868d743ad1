// What there is to do next, on the screen that one is on and as the work
// stands.
#pragma once

#include "tui/workbench/snapshot.hpp"

#include <cstddef>
#include <string>

namespace tapfit::tui {

/// "next: 14.7 % is 11 times the floor: 5 shows what is missing".
/// @param screen 0 for the first one
/// @return empty where what it depends on is not known yet
[[nodiscard]] std::string step_words(std::size_t screen, const Snapshot& known);

}  // namespace tapfit::tui
