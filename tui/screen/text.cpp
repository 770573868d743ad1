#include "tui/screen/text.hpp"

#include <algorithm>
#include <array>
#include <clocale>
#include <cstdint>
#include <cwchar>
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

// Whatever the user's locale is, so that widths are those of a terminal that
// shows UTF-8, and the same for screens that no terminal shows.
class Utf8Locale {
 public:
  Utf8Locale() : locale_(newlocale(LC_CTYPE_MASK, "C.UTF-8", nullptr)) {}
  ~Utf8Locale() {
    if (locale_ != nullptr) freelocale(locale_);
  }
  Utf8Locale(const Utf8Locale&) = delete;
  Utf8Locale& operator=(const Utf8Locale&) = delete;

  /// Cells; -1 for control characters and what is no character.
  [[nodiscard]] int width(char32_t g) const {
    if (locale_ == nullptr) return -1;
    const locale_t before = uselocale(locale_);
    const int cells = wcwidth(static_cast<wchar_t>(g));
    uselocale(before);
    return cells;
  }

 private:
  locale_t locale_;
};

int cells_of(char32_t g) {
  if (g < 0x20 || (g >= 0x7F && g < 0xA0)) return -1;
  if (g < 0x300) return 1;
  static const Utf8Locale utf8;
  return utf8.width(g);
}

// Joiners, marks of direction and of variants, byte order marks, tags.
bool is_unseen(char32_t g) {
  return (g >= 0x2000 && g <= 0x206F) || (g >= 0xFE00 && g <= 0xFE0F) ||
         g == 0xFEFF || g >= 0xE0000;
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

std::vector<Glyph> decode(std::string_view utf8) {
  std::vector<Glyph> glyphs;
  glyphs.reserve(utf8.size());
  while (!utf8.empty()) {
    const Decoded next = decode_one(utf8);
    utf8.remove_prefix(next.bytes);
    const int cells = cells_of(next.glyph);
    if (cells > 0) {
      glyphs.push_back({next.glyph, 0, cells});
    } else if (cells < 0) {
      glyphs.push_back({U'?'});
    } else if (!is_unseen(next.glyph) && !glyphs.empty() &&
               glyphs.back().mark == 0) {
      glyphs.back().mark = next.glyph;
    }
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
  for (const auto& [g, mark, width] : decode(utf8)) {
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
  int width = 0;
  for (const Glyph& glyph : decode(utf8)) width += glyph.width;
  return width;
}

std::string clipped(std::string_view utf8, int width) {
  if (width <= 0) return {};
  const bool whole = text_width(utf8) <= width;
  const int room = whole ? width : width - 1;
  std::string text;
  int used = 0;
  for (const Glyph& glyph : decode(utf8)) {
    used += glyph.width;
    if (used > room) break;
    append_utf8(text, glyph.base);
    if (glyph.mark != 0) append_utf8(text, glyph.mark);
  }
  if (!whole) append_utf8(text, U'…');
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
