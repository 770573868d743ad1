// UTF-8 text as cells: decoding, encoding, and the ASCII that stands in where
// the terminal knows no better.
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace tapfit::tui {

/// What fills one cell, or two.
struct Glyph {
  char32_t base = U' ';
  char32_t mark = 0;  ///< an accent over it, where there is one
  int width = 1;      ///< [cells]: 2 for Han, Hangul, emoji
};

/// UTF-8 text glyph by glyph. Bytes that are no UTF-8 and control characters
/// become '?'; what joins glyphs or turns their direction is left out, and so
/// are accents beyond the first.
[[nodiscard]] std::vector<Glyph> decode(std::string_view utf8);

/// Appends one code point as UTF-8.
void append_utf8(std::string& text, char32_t glyph);

/// The text in ASCII: "±" becomes "+-", "²" becomes "^2"; else '?'.
[[nodiscard]] std::string to_ascii(std::string_view utf8);

/// One glyph in ASCII, one cell wide: box lines to + - |, blocks to #.
[[nodiscard]] char32_t ascii_glyph(char32_t glyph);

/// Cells that the text fills.
[[nodiscard]] int text_width(std::string_view utf8);

/// At most `width` cells of the text, the last one "…" where it was cut.
[[nodiscard]] std::string clipped(std::string_view utf8, int width);

/// The text in lines of at most `width` cells, broken at spaces.
[[nodiscard]] std::vector<std::string> wrapped(std::string_view utf8,
                                               int width);

/// As wrapped(), at most `rows` lines, the last one "…" where it was cut.
[[nodiscard]] std::vector<std::string> wrapped(std::string_view utf8,
                                               int width,
                                               int rows);

}  // namespace tapfit::tui
