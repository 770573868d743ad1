// Terminal colours of Colour, so that each can be read on the background it is
// for and colour-blind eyes tell those apart that stand together.
//
// Source: WCAG 2.1, success criterion 1.4.3 (contrast of text, 4.5 : 1), held
// against the colours that xterm has by default.
#pragma once

#include "tui/screen/screen.hpp"

#include <array>

namespace tapfit::tui {

/// Number of the terminal's colour per Colour; -1 is its own.
using Palette = std::array<short, colour_count>;

/// @param colours that the terminal has: 8, 16 or 256 are made use of
/// @param light whether its background is
[[nodiscard]] const Palette& palette(int colours, bool light);

}  // namespace tapfit::tui
