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

enum class Theme {
  Default,
  HighContrast,  ///< 7 : 1, where there are 256 colours (criterion 1.4.6)
  Mono           ///< none but the terminal's own
};

/// @param colours that the terminal has: 8, 16 or 256 are made use of
/// @param light whether its background is
/// @pre the theme is not Mono
[[nodiscard]] const Palette& palette(int colours,
                                     bool light,
                                     Theme theme = Theme::Default);

/// Paper and ink of a heat map's cell.
struct HeatColour {
  short paper = -1;
  short ink = -1;
};

/// From no heat, the terminal's own, to the most, where there are 256 colours.
/// It stands out from the background the more, the hotter it is.
[[nodiscard]] const std::array<HeatColour, heat_levels + 1>& heat_palette(
    bool light);

}  // namespace tapfit::tui
