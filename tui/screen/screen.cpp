#include "tui/screen/screen.hpp"

#include "tui/screen/text.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cassert>
#include <cmath>
#include <utility>

namespace tapfit::tui {

double Zone::value_at(int x) const {
  const double share =
      rect.width > 1 ? static_cast<double>(x - rect.x) / (rect.width - 1) : 0.0;
  return log ? from * std::pow(to / from, share) : from + share * (to - from);
}

Screen::Screen(int width, int height, bool ascii)
    : width_(std::max(width, 0)),
      height_(std::max(height, 0)),
      ascii_(ascii),
      cells_(static_cast<std::size_t>(width_) *
             static_cast<std::size_t>(height_)) {}

const Cell& Screen::at(int x, int y) const {
  assert(area().holds(x, y));
  return cells_[static_cast<std::size_t>(y) * static_cast<std::size_t>(width_) +
                static_cast<std::size_t>(x)];
}

Cell& Screen::cell(int x, int y) {
  return cells_[static_cast<std::size_t>(y) * static_cast<std::size_t>(width_) +
                static_cast<std::size_t>(x)];
}

// Half of a wide glyph does not stay behind.
void Screen::set(int x, int y, const Cell& cell) {
  if (!area().holds(x, y)) return;
  const auto blank = [&](int column) {
    this->cell(column, y) = {U' ', at(column, y).style};
  };
  if (at(x, y).glyph == 0 && x > 0 && cell.glyph != 0) blank(x - 1);
  if (x + 1 < width_ && at(x + 1, y).glyph == 0) blank(x + 1);
  this->cell(x, y) = cell;
}

void Screen::cover(int x, int y) {
  if (!area().holds(x, y) || at(x, y).glyph != U' ') return;
  for (PixelPicture& picture : pictures_) clear_cell(picture, x, y);
}

void Screen::put(int x, int y, char32_t glyph, Style style) {
  set(x, y, {ascii_ ? ascii_glyph(glyph) : glyph, style});
  cover(x, y);
}

int Screen::text(int x, int y, std::string_view utf8, Style style, int width) {
  const std::string shown =
      clipped(ascii_ ? to_ascii(utf8) : std::string(utf8), width);
  for (const Glyph& glyph : decode(shown)) {
    const bool fits = glyph.width == 1 || area().holds(x + 1, y);
    const char32_t base = ascii_ ? ascii_glyph(glyph.base) : glyph.base;
    set(x, y, {fits ? base : U' ', style, glyph.mark});
    if (glyph.width == 2) set(x + 1, y, {0, style});
    x += glyph.width;
  }
  return x;
}

void Screen::text_right(
    int x_end, int y, std::string_view utf8, Style style, int width) {
  const std::string shown =
      clipped(ascii_ ? to_ascii(utf8) : std::string(utf8), width);
  text(x_end - text_width(shown), y, shown, style, width);
}

void Screen::fill(const Rect& rect, char32_t glyph, Style style) {
  for (int y = rect.y; y < rect.y + rect.height; ++y) {
    for (int x = rect.x; x < rect.x + rect.width; ++x) put(x, y, glyph, style);
  }
}

void Screen::box(const Rect& rect, std::string_view title, Style style) {
  if (rect.width < 2 || rect.height < 2) return;
  const int right = rect.x + rect.width - 1;
  const int bottom = rect.y + rect.height - 1;
  for (int x = rect.x + 1; x < right; ++x) {
    put(x, rect.y, U'─', style);
    put(x, bottom, U'─', style);
  }
  for (int y = rect.y + 1; y < bottom; ++y) {
    put(rect.x, y, U'│', style);
    put(right, y, U'│', style);
  }
  put(rect.x, rect.y, U'┌', style);
  put(right, rect.y, U'┐', style);
  put(rect.x, bottom, U'└', style);
  put(right, bottom, U'┘', style);
  if (!title.empty() && rect.width > 6) {
    const std::string padded = fmt::format(" {} ", title);
    text(rect.x + 2, rect.y, padded, style, rect.width - 4);
  }
}

void Screen::add(const PixelPicture& picture) {
  PixelPicture seen = part_within(picture, area());
  if (!seen.blank()) pictures_.push_back(std::move(seen));
}

void Screen::place(int x, int y, const Screen& other) {
  for (int row = 0; row < other.height(); ++row) {
    for (int column = 0; column < other.width(); ++column) {
      set(x + column, y + row, other.at(column, row));
      cover(x + column, y + row);
    }
  }
  for (PixelPicture picture : other.pictures_) {
    picture.rect.x += x;
    picture.rect.y += y;
    add(picture);
  }
  for (Zone zone : other.zones_) {
    zone.rect.x += x;
    zone.rect.y += y;
    zones_.push_back(zone);
  }
}

void Screen::name_pane(const Rect& rect, std::size_t number) {
  for (Zone& zone : zones_) {
    if (rect.holds(zone.rect.x, zone.rect.y)) zone.pane = number;
  }
}

const Zone* Screen::zone_at(int x, int y) const {
  const auto found =
      std::find_if(zones_.rbegin(), zones_.rend(), [&](const Zone& zone) {
        return zone.rect.holds(x, y);
      });
  return found == zones_.rend() ? nullptr : &*found;
}

std::string Screen::to_text() const {
  std::string text;
  for (int y = 0; y < height_; ++y) {
    std::string line;
    std::size_t used = 0;
    for (int x = 0; x < width_; ++x) {
      const auto& [glyph, style, mark] = at(x, y);
      if (glyph != 0) append_utf8(line, glyph);
      if (mark != 0) append_utf8(line, mark);
      if (glyph != U' ') used = line.size();
    }
    line.resize(used);
    text += line + "\n";
  }
  return text;
}

}  // namespace tapfit::tui
