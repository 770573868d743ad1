// Terminal colours of Colour, so that each can be read on the background it is
// for and colour-blind eyes tell those apart that stand together.
//
// Source: WCAG 2.1, success criterion 1.4.3 (contrast of text, 4.5 : 1), held
// against the colours that xterm has by default.
#pragma once

#include "tui/screen/screen.hpp"

#include <array>
#include <cstdint>

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

struct Rgb {
  std::uint8_t red = 0;
  std::uint8_t green = 0;
  std::uint8_t blue = 0;

  bool operator==(const Rgb&) const = default;
};

/// Of one of 256 colours, as xterm has them by default.
/// @param number 0 to 255
[[nodiscard]] Rgb rgb_of(short number);

/// Inks of pictures: the colours, then the same dimmed.
using Inks = std::array<Rgb, std::size_t{2} * colour_count>;
[[nodiscard]] std::uint8_t ink_number(Colour colour, bool dim);

/// The palette of 256 colours as pixels. The terminal's own ink is taken as
/// light grey or black, so are all of Theme::Mono.
[[nodiscard]] Inks inks(bool light, Theme theme);

}  // namespace tapfit::tui
