// Contrast of each ink with its background, as WCAG 2.1 defines it.
#include "tui/screen/palette.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace tapfit::tui {
namespace {

using Triple = std::array<int, 3>;

/// What xterm shows for a colour's number by default.
Triple shown(int number) {
  static constexpr std::array<Triple, 16> plain{{
      {0, 0, 0},
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
      {255, 255, 255},
  }};
  if (number < 16) return plain[static_cast<std::size_t>(number)];
  if (number >= 232) {
    const int grey = 8 + 10 * (number - 232);
    return {grey, grey, grey};
  }
  static constexpr std::array<int, 6> level{0, 95, 135, 175, 215, 255};
  const auto cube = static_cast<std::size_t>(number - 16);
  return {level[cube / 36], level[cube / 6 % 6], level[cube % 6]};
}

double luminance(const Triple& colour) {
  const auto linear = [](int value) {
    const double c = value / 255.0;
    return c <= 0.03928 ? c / 12.92 : std::pow((c + 0.055) / 1.055, 2.4);
  };
  return 0.2126 * linear(colour[0]) + 0.7152 * linear(colour[1]) +
         0.0722 * linear(colour[2]);
}

double contrast(const Triple& a, const Triple& b) {
  const auto [low, high] = std::minmax({luminance(a), luminance(b)});
  return (high + 0.05) / (low + 0.05);
}

TEST(Palette, ContrastIsAsDefined) {
  EXPECT_NEAR(contrast(shown(0), shown(15)), 21.0, 1e-9);
  EXPECT_NEAR(contrast(shown(243), shown(15)), 4.54, 0.01);  // #767676
}

TEST(Palette, EveryInkCanBeReadOnItsBackground) {
  for (const bool light : {false, true}) {
    const Triple ground = shown(light ? 15 : 0);
    for (const int colours : {8, 16, 256}) {
      // With few colours there is no red better than 3, what figures need.
      const double least = colours == 256 ? 4.5 : 3.0;
      for (const short ink : palette(colours, light)) {
        if (ink < 0) continue;
        EXPECT_LT(ink, colours);
        EXPECT_GE(contrast(shown(ink), ground), least)
            << ink << " of " << colours << (light ? " on light" : " on dark");
      }
    }
  }
}

// Criterion 1.4.6.
TEST(Palette, HighContrastIsHigh) {
  for (const bool light : {false, true}) {
    const Triple ground = shown(light ? 15 : 0);
    Palette inks = palette(256, light, Theme::HighContrast);
    for (const short ink : inks) {
      if (ink < 0) continue;
      EXPECT_GE(contrast(shown(ink), ground), 7.0) << ink;
    }
    std::ranges::sort(inks);
    EXPECT_EQ(std::ranges::adjacent_find(inks), inks.end());
  }
}

TEST(Palette, HeatStandsOutTheMoreTheHotterItIs) {
  for (const bool light : {false, true}) {
    const Triple ground = shown(light ? 15 : 0);
    double before = 1.0;
    for (int heat = 1; heat <= heat_levels; ++heat) {
      const HeatColour& cell =
          heat_palette(light)[static_cast<std::size_t>(heat)];
      const double stands_out = contrast(shown(cell.paper), ground);
      EXPECT_GT(stands_out, before) << heat << (light ? " on light" : "");
      before = stands_out;
      EXPECT_GE(contrast(shown(cell.ink), shown(cell.paper)), 4.5) << heat;
    }
  }
}

TEST(Palette, InksDifferWhereThereAreEnough) {
  for (const bool light : {false, true}) {
    Palette inks = palette(256, light);
    std::ranges::sort(inks);
    EXPECT_EQ(std::ranges::adjacent_find(inks), inks.end());
  }
}

TEST(Palette, IsKnownInPixelsToo) {
  for (short number = 0; number < 256; ++number) {
    const Rgb own = rgb_of(number);
    EXPECT_EQ((Triple{own.red, own.green, own.blue}), shown(number)) << number;
  }
  const Inks dark = inks(false, Theme::Default);
  EXPECT_EQ(dark[ink_number(Colour::Blue, false)], rgb_of(33));
  EXPECT_EQ(dark[ink_number(Colour::Blue, true)], (Rgb{0, 67, 127}));
  // Without colours all are the terminal's own.
  const Inks mono = inks(true, Theme::Mono);
  EXPECT_EQ(mono[ink_number(Colour::Blue, false)], (Rgb{0, 0, 0}));
}

}  // namespace
}  // namespace tapfit::tui
