// What a terminal can show of what screens are drawn with: braille dots, where
// its font lacks them quarter blocks, else ASCII (text.hpp).
#pragma once

#include <string_view>

namespace tapfit::tui {

enum class Glyphs { Braille, Blocks, Ascii };

/// Quarter blocks for a braille glyph: each stands for two of its eight dots
/// and is filled where one of them is. Other glyphs stay as they are.
[[nodiscard]] char32_t block_glyph(char32_t glyph);

/// What the terminal's kind has glyphs for, where nothing else is asked for.
///
/// @param terminal as TERM says; the Linux console's fonts have no braille
/// @param utf8 whether the locale's characters are UTF-8
[[nodiscard]] Glyphs glyphs_of(std::string_view terminal, bool utf8);

/// Whether the background is light.
///
/// @param colour_fg_bg as the variable COLORFGBG says, "15;0" or
///   "0;default;15": the last number is the background's colour of 16; empty
///   or anything else means dark
[[nodiscard]] bool is_light(std::string_view colour_fg_bg);

}  // namespace tapfit::tui
