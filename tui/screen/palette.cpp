#include "tui/screen/palette.hpp"

namespace tapfit::tui {
namespace {

// Default, blue, orange, green, red, purple, sky, yellow, grey.
constexpr Palette dark_256{-1, 33, 214, 36, 202, 175, 117, 227, 245};
constexpr Palette dark_16{-1, 12, 3, 2, 9, 13, 14, 11, 8};
constexpr Palette dark_8{-1, 6, 3, 2, 1, 5, 6, 3, -1};
constexpr Palette light_256{-1, 20, 130, 28, 160, 90, 24, 58, 242};
// Of the plain colours only blue, red and magenta are dark enough on white.
constexpr Palette light_16{-1, 4, 1, -1, 1, 5, 12, 5, -1};
constexpr Palette contrast_on_dark{-1, 75, 214, 48, 209, 213, 123, 227, 252};
constexpr Palette contrast_on_light{-1, 19, 52, 22, 124, 90, 24, 16, 238};
constexpr Palette light_8{-1, 4, 1, -1, 1, 5, 4, 5, -1};

using HeatPalette = std::array<HeatColour, heat_levels + 1>;

constexpr short black = 16;
constexpr short white = 255;

// Dark blue to yellow, and pale yellow to dark blue.
constexpr HeatPalette heat_on_dark{{{-1, -1},
                                    {17, white},
                                    {18, white},
                                    {25, white},
                                    {30, black},
                                    {142, black},
                                    {220, black}}};
constexpr HeatPalette heat_on_light{{{-1, -1},
                                     {230, black},
                                     {193, black},
                                     {115, black},
                                     {73, black},
                                     {25, white},
                                     {18, white}}};

constexpr std::array<Rgb, 16> plain_colours{{{0, 0, 0},
                                             {205, 0, 0},
                                             {0, 205, 0},
                                             {205, 205, 0},
                                             {0, 0, 238},
                                             {205, 0, 205},
                                             {0, 205, 205},
                                             {229, 229, 229},
                                             {127, 127, 127},
                                             {255, 0, 0},
                                             {0, 255, 0},
                                             {255, 255, 0},
                                             {92, 92, 255},
                                             {255, 0, 255},
                                             {0, 255, 255},
                                             {255, 255, 255}}};
constexpr short first_of_cube = 16;
constexpr short first_grey = 232;

/// Half of the way to the background's black or white.
std::uint8_t dimmed(std::uint8_t value, bool light) {
  return static_cast<std::uint8_t>((value + (light ? 255 : 0)) / 2);
}

}  // namespace

const HeatPalette& heat_palette(bool light) {
  return light ? heat_on_light : heat_on_dark;
}

const Palette& palette(int colours, bool light, Theme theme) {
  if (colours >= 256 && theme == Theme::HighContrast) {
    return light ? contrast_on_light : contrast_on_dark;
  }
  if (colours >= 256) return light ? light_256 : dark_256;
  if (colours >= 16) return light ? light_16 : dark_16;
  return light ? light_8 : dark_8;
}

Rgb rgb_of(short number) {
  if (number < first_of_cube) {
    return plain_colours[static_cast<std::size_t>(number)];
  }
  if (number >= first_grey) {
    const auto grey = static_cast<std::uint8_t>(8 + 10 * (number - first_grey));
    return {grey, grey, grey};
  }
  // A cube of six steps each way.
  const int place = number - first_of_cube;
  const auto level = [](int step) {
    return static_cast<std::uint8_t>(step == 0 ? 0 : 55 + 40 * step);
  };
  return {level(place / 36), level(place / 6 % 6), level(place % 6)};
}

std::uint8_t ink_number(Colour colour, bool dim) {
  const int number = static_cast<int>(colour) + (dim ? colour_count : 0);
  return static_cast<std::uint8_t>(number);
}

Inks inks(bool light, Theme theme) {
  constexpr short light_grey = 252;
  Inks all{};
  for (std::size_t i = 0; i < colour_count; ++i) {
    const short number =
        theme == Theme::Mono ? short{-1} : palette(256, light, theme)[i];
    const Rgb ink = rgb_of(number >= 0 ? number : light ? black : light_grey);
    all[i] = ink;
    all[i + colour_count] = {dimmed(ink.red, light),
                             dimmed(ink.green, light),
                             dimmed(ink.blue, light)};
  }
  return all;
}

}  // namespace tapfit::tui
