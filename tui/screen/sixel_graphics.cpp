#include "tui/screen/sixel_graphics.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <iterator>
#include <map>
#include <set>

namespace tapfit::tui {
namespace {

constexpr int band_rows = 6;
constexpr std::uint8_t half_covered = 128;

bool is_drawn(const Pixel& pixel) { return pixel.cover >= half_covered; }

int percent_of(std::uint8_t value) { return (100 * value + 127) / 255; }

/// The ink's pixels of each column, the uppermost in the lowest bit.
std::vector<unsigned> columns_of(const PixelPicture& picture,
                                 int top,
                                 std::uint8_t ink) {
  const int rows = std::min(band_rows, picture.height() - top);
  std::vector<unsigned> columns(static_cast<std::size_t>(picture.width()));
  for (int row = 0; row < rows; ++row) {
    for (int x = 0; x < picture.width(); ++x) {
      const Pixel& pixel = picture.at(x, top + row);
      if (!is_drawn(pixel) || pixel.ink != ink) continue;
      columns[static_cast<std::size_t>(x)] |= 1U << static_cast<unsigned>(row);
    }
  }
  while (!columns.empty() && columns.back() == 0) columns.pop_back();
  return columns;
}

void write_columns(std::string& text, const std::vector<unsigned>& columns) {
  for (auto at = columns.begin(); at != columns.end();) {
    const auto end =
        std::find_if(at, columns.end(), [at](unsigned c) { return c != *at; });
    const auto count = static_cast<std::size_t>(std::distance(at, end));
    const char character = static_cast<char>('?' + *at);
    if (count > 3) {
      text += fmt::format("!{}{}", count, character);
    } else {
      text.append(count, character);
    }
    at = end;
  }
}

std::set<std::uint8_t> inks_in(const PixelPicture& picture, int top, int rows) {
  std::set<std::uint8_t> found;
  const int end = std::min(top + rows, picture.height());
  for (int y = top; y < end; ++y) {
    for (int x = 0; x < picture.width(); ++x) {
      const Pixel& pixel = picture.at(x, y);
      if (is_drawn(pixel)) found.insert(pixel.ink);
    }
  }
  return found;
}

/// Colour registers of the inks in use, from 1: some terminals have 16, the
/// first of which is the background.
using Registers = std::map<std::uint8_t, int>;

Registers registers_for(const PixelPicture& picture) {
  Registers registers;
  for (const std::uint8_t ink : inks_in(picture, 0, picture.height())) {
    const int next = static_cast<int>(registers.size()) + 1;
    registers[ink] = next;
  }
  return registers;
}

}  // namespace

std::string sixel_sequence(const PixelPicture& picture, const Inks& inks) {
  std::string text =
      fmt::format("\033P0;1;0q\"1;1;{};{}", picture.width(), picture.height());
  const Registers registers = registers_for(picture);
  for (const auto& [ink, number] : registers) {
    const Rgb& rgb = inks[ink];
    text += fmt::format("#{};2;{};{};{}",
                        number,
                        percent_of(rgb.red),
                        percent_of(rgb.green),
                        percent_of(rgb.blue));
  }
  for (int top = 0; top < picture.height(); top += band_rows) {
    if (top > 0) text += '-';
    bool first = true;
    for (const std::uint8_t ink : inks_in(picture, top, band_rows)) {
      text += fmt::format("{}#{}", first ? "" : "$", registers.at(ink));
      write_columns(text, columns_of(picture, top, ink));
      first = false;
    }
  }
  return text + "\033\\";
}

}  // namespace tapfit::tui
