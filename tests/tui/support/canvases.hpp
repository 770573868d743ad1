// The sizes that views are drawn at.
#pragma once

#include "tui/screen/screen.hpp"

#include <vector>

namespace tapfit::tui {

inline const std::vector<Canvas> sizes{{80, 21, false}, {120, 32, false}};

}  // namespace tapfit::tui
