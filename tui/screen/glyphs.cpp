#include "tui/screen/glyphs.hpp"

#include <array>
#include <charconv>
#include <system_error>

namespace tapfit::tui {

char32_t block_glyph(char32_t glyph) {
  if (glyph < 0x2800U || glyph > 0x28FFU) return glyph;
  const auto dots = static_cast<unsigned>(glyph - 0x2800U);
  // Rows 1 and 2 are bits 0, 1 (left) and 3, 4 (right); rows 3 and 4 are bits
  // 2, 6 and 5, 7.
  unsigned quarters = 0;
  if ((dots & 0x03U) != 0) quarters |= 1U;
  if ((dots & 0x18U) != 0) quarters |= 2U;
  if ((dots & 0x44U) != 0) quarters |= 4U;
  if ((dots & 0xA0U) != 0) quarters |= 8U;
  static constexpr std::array<char32_t, 16> blocks{U' ',
                                                   U'▘',
                                                   U'▝',
                                                   U'▀',
                                                   U'▖',
                                                   U'▌',
                                                   U'▞',
                                                   U'▛',
                                                   U'▗',
                                                   U'▚',
                                                   U'▐',
                                                   U'▜',
                                                   U'▄',
                                                   U'▙',
                                                   U'▟',
                                                   U'█'};
  return blocks[quarters];
}

Glyphs glyphs_of(std::string_view terminal, bool utf8) {
  if (!utf8 || terminal == "dumb") return Glyphs::Ascii;
  return terminal == "linux" ? Glyphs::Blocks : Glyphs::Braille;
}

bool is_light(std::string_view colour_fg_bg) {
  const std::size_t last = colour_fg_bg.rfind(';');
  if (last == std::string_view::npos) return false;
  const std::string_view number = colour_fg_bg.substr(last + 1);
  int colour = 0;
  const char* end = number.data() + number.size();
  const auto [read, error] = std::from_chars(number.data(), end, colour);
  if (error != std::errc() || read != end) return false;
  return colour == 7 || (colour >= 9 && colour <= 15);
}

}  // namespace tapfit::tui
