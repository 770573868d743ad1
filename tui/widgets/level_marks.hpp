// Four levels as marks on a structure, told apart without colour, too.
#pragma once

#include "tui/screen/screen.hpp"

#include <array>

namespace tapfit::tui {

struct LevelMark {
  char32_t glyph = U'●';
  Colour colour = Colour::Default;
};

/// From the least to the most.
inline constexpr std::array<LevelMark, 4> level_marks{{{U'+', Colour::Green},
                                                       {U'o', Colour::Yellow},
                                                       {U'O', Colour::Orange},
                                                       {U'●', Colour::Red}}};

}  // namespace tapfit::tui
