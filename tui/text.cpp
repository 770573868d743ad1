#include "tui/text.hpp"

#include <algorithm>
#include <array>
#include <cstdint>
#include <utility>

namespace tapfit::tui {
namespace {

struct Decoded {
  char32_t glyph;
  std::size_t bytes;
};

bool continues(char c) {
  return (static_cast<unsigned char>(c) & 0xC0U) == 0x80U;
}

Decoded decode_one(std::string_view text) {
  const auto lead = static_cast<unsigned char>(text[0]);
  if (lead < 0x80U) return {lead, 1};
  const std::size_t length = lead >= 0xF0U && lead < 0xF8U ? 4
                             : lead >= 0xE0U               ? 3
                             : lead >= 0xC2U               ? 2
                                                           : 0;
  if (length == 0 || lead >= 0xF8U || text.size() < length) return {U'?', 1};
  char32_t glyph = lead & (0xFFU >> (length + 1));
  for (std::size_t i = 1; i < length; ++i) {
    if (!continues(text[i])) return {U'?', i};
    glyph = (glyph << 6U) | (static_cast<unsigned char>(text[i]) & 0x3FU);
  }
  return {glyph, length};
}

bool fills_one_cell(char32_t g) {
  if (g < 0x20 || (g >= 0x7F && g < 0xA0)) return false;
  if (g >= 0x0300 && g <= 0x036F) return false;  // combining
  if (g >= 0x1100 && g <= 0x115F) return false;  // wide: Hangul
  if (g >= 0x200B && g <= 0x200F) return false;  // no width
  if (g >= 0x202A && g <= 0x202E) return false;  // direction marks
  if (g >= 0x2E80 && g <= 0xA4CF) return false;  // wide: CJK
  if (g >= 0xAC00 && g <= 0xD7FF) return false;
  if (g >= 0xD800 && g <= 0xFAFF) return false;
  if (g >= 0xFE00 && g <= 0xFE6F) return false;
  return g < 0xFF00;
}

std::string_view ascii_for(char32_t g) {
  using Pair = std::pair<char32_t, std::string_view>;
  static constexpr std::array<Pair, 24> table{{
      {U'±', "+-"},   {U'²', "^2"},  {U'³', "^3"},  {U'·', "."},
      {U'×', "x"},    {U'–', "-"},   {U'—', "-"},   {U'−', "-"},
      {U'…', "..."},  {U'→', "->"},  {U'←', "<-"},  {U'↑', "^"},
      {U'↓', "v"},    {U'°', "deg"}, {U'ω', "w"},   {U'σ', "sigma"},
      {U'ζ', "zeta"}, {U'π', "pi"},  {U'ρ', "rho"}, {U'∠', "phase"},
      {U'✓', "+"},    {U'✗', "x"},   {U'≤', "<="},  {U'≥', ">="},
  }};
  for (const Pair& pair : table) {
    if (pair.first == g) return pair.second;
  }
  return {};
}

}  // namespace

std::vector<char32_t> decode(std::string_view utf8) {
  std::vector<char32_t> glyphs;
  glyphs.reserve(utf8.size());
  while (!utf8.empty()) {
    const Decoded next = decode_one(utf8);
    glyphs.push_back(fills_one_cell(next.glyph) ? next.glyph : U'?');
    utf8.remove_prefix(next.bytes);
  }
  return glyphs;
}

void append_utf8(std::string& text, char32_t g) {
  const auto byte = [&text](std::uint32_t b) {
    text.push_back(static_cast<char>(b));
  };
  if (g < 0x80U) {
    byte(g);
  } else if (g < 0x800U) {
    byte(0xC0U | (g >> 6U));
    byte(0x80U | (g & 0x3FU));
  } else if (g < 0x10000U) {
    byte(0xE0U | (g >> 12U));
    byte(0x80U | ((g >> 6U) & 0x3FU));
    byte(0x80U | (g & 0x3FU));
  } else {
    byte(0xF0U | (g >> 18U));
    byte(0x80U | ((g >> 12U) & 0x3FU));
    byte(0x80U | ((g >> 6U) & 0x3FU));
    byte(0x80U | (g & 0x3FU));
  }
}

char32_t ascii_glyph(char32_t g) {
  if (g < 0x7F) return g;
  if (g == U'│' || g == U'┃' || g == U'┤' || g == U'├') return U'|';
  if (g == U'─' || g == U'━' || g == U'┬' || g == U'┴') return U'-';
  if (g >= 0x2500 && g < 0x2580) return U'+';
  if (g >= 0x2580 && g < 0x25A0) return g == U'░' ? U'.' : U'#';
  if (g == U'●' || g == U'◆' || g == U'▲' || g == U'■') return U'@';
  if (g == U'○' || g == U'◇' || g == U'△' || g == U'□') return U'o';
  if (g == U'▶' || g == U'▸') return U'>';
  if (g == U'▼' || g == U'▾') return U'v';
  if (g > 0x2800 && g < 0x2900) return U'*';
  if (g == 0x2800) return U' ';
  const std::string_view text = ascii_for(g);
  return text.empty() ? U'?' : static_cast<char32_t>(text[0]);
}

std::string to_ascii(std::string_view utf8) {
  std::string text;
  for (const char32_t g : decode(utf8)) {
    const std::string_view known = g < 0x7F ? "" : ascii_for(g);
    if (!known.empty()) {
      text += known;
    } else {
      text.push_back(static_cast<char>(ascii_glyph(g)));
    }
  }
  return text;
}

int text_width(std::string_view utf8) {
  return static_cast<int>(decode(utf8).size());
}

std::string clipped(std::string_view utf8, int width) {
  if (width <= 0) return {};
  const std::vector<char32_t> glyphs = decode(utf8);
  const auto room = static_cast<std::size_t>(width);
  std::string text;
  for (std::size_t i = 0; i < std::min(room, glyphs.size()); ++i) {
    const bool cut = i + 1 == room && glyphs.size() > room;
    append_utf8(text, cut ? U'…' : glyphs[i]);
  }
  return text;
}

std::vector<std::string> wrapped(std::string_view utf8, int width) {
  std::vector<std::string> lines;
  std::string line;
  const auto take = [&](const std::string& word) {
    const int needed = text_width(line) + (line.empty() ? 0 : 1);
    if (!line.empty() && needed + text_width(word) > width) {
      lines.push_back(line);
      line.clear();
    }
    if (!line.empty()) line += ' ';
    line += clipped(word, width);
  };
  std::string word;
  for (const char c : utf8) {
    if (c != ' ' && c != '\n') {
      word.push_back(c);
      continue;
    }
    if (!word.empty()) take(word);
    word.clear();
    if (c == '\n') {
      lines.push_back(line);
      line.clear();
    }
  }
  if (!word.empty()) take(word);
  if (!line.empty()) lines.push_back(line);
  return lines;
}

std::vector<std::string> wrapped(std::string_view utf8, int width, int rows) {
  std::vector<std::string> lines = wrapped(utf8, width);
  const auto room = static_cast<std::size_t>(std::max(rows, 1));
  if (lines.size() <= room) return lines;
  std::string rest;
  for (std::size_t i = room - 1; i < lines.size(); ++i) {
    rest += (rest.empty() ? "" : " ") + lines[i];
  }
  lines.resize(room);
  lines.back() = clipped(rest, width);
  return lines;
}

}  // namespace tapfit::tui
