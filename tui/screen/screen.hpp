// The room tui/screen. Cells, colours, keys and the terminal. Nothing here
// knows a test.
// In:  Keys.
// Out: A screen of cells.
// May include: its row in CONTRIBUTING.md.
//
// A grid of cells: what every view returns and the terminal shows. Nothing
// here knows a terminal, so that screens are compared as text.
#pragma once

#include "tui/screen/layout.hpp"
#include "tui/screen/pixel_picture.hpp"

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace tapfit::tui {

/// Colours that stay apart for colour-blind eyes (after Okabe and Ito).
enum class Colour : std::uint8_t {
  Default,
  Blue,
  Orange,
  Green,
  Red,
  Purple,
  Sky,
  Yellow,
  Grey,
};
inline constexpr int colour_count = 9;

struct Style {
  Colour colour = Colour::Default;
  std::uint8_t heat = 0;  ///< background: 0 none, 1 (cold) .. 6 (hot)
  bool bold = false;
  bool dim = false;
  bool reverse = false;

  bool operator==(const Style&) const = default;
};
inline constexpr int heat_levels = 6;

struct Cell {
  char32_t glyph = U' ';  ///< 0: the one before it fills two cells
  Style style;
  char32_t mark = 0;  ///< an accent over it, where there is one

  bool operator==(const Cell&) const = default;
};

/// Where a click means something: a row of a list, a column's heading, a place
/// along a plot's x axis, a key of the key bar, an entry of a map, a command of
/// the palette.
struct Zone {
  enum class Kind { Row, Heading, PlotX, Key, Entry, Command };
  Rect rect;
  Kind kind = Kind::Row;
  /// Of the row (also of an entry's) or of the command, or the key.
  std::size_t index = 0;
  std::size_t column = 0;  ///< of the entry; of a heading 1: of numbers
  std::size_t pane = 0;    ///< which of several lists or maps it is in
  double from = 0.0;       ///< x at the first and at the last column of cells
  double to = 0.0;
  bool log = false;
  std::string name = {};  ///< of a heading's column

  /// The value under that column of cells.
  [[nodiscard]] double value_at(int x) const;
};

struct Drawings;  // tui/widgets/drawing.hpp

/// How large a view may be and which glyphs it may use.
struct Canvas {
  int width = 80;
  int height = 24;
  bool ascii = false;
  Drawings* drawings = nullptr;  ///< takes what is plotted, where asked for
  CellPixels pixels = {};        ///< that plots are drawn in, where there are
};

/// Whatever is put outside of the grid is dropped; with `ascii`, every glyph
/// put is replaced by its ASCII stand-in.
class Screen {
 public:
  Screen(int width, int height, bool ascii = false);
  explicit Screen(const Canvas& canvas)
      : Screen(canvas.width, canvas.height, canvas.ascii) {
    drawings_ = canvas.drawings;
    pixels_ = canvas.pixels;
  }

  [[nodiscard]] int width() const { return width_; }
  [[nodiscard]] int height() const { return height_; }
  [[nodiscard]] bool ascii() const { return ascii_; }
  /// The canvas's.
  [[nodiscard]] Drawings* drawings() const { return drawings_; }
  [[nodiscard]] CellPixels pixels() const { return pixels_; }
  [[nodiscard]] Rect area() const { return {0, 0, width_, height_}; }

  /// @pre 0 <= x < width, 0 <= y < height
  [[nodiscard]] const Cell& at(int x, int y) const;

  /// @param glyph that fills one cell
  void put(int x, int y, char32_t glyph, Style style = {});
  /// Writes UTF-8 text, at most `width` cells; returns the cell after it.
  int text(int x,
           int y,
           std::string_view utf8,
           Style style = {},
           int width = 100000);
  /// As text(), ending in the cell before `x_end`.
  void text_right(int x_end,
                  int y,
                  std::string_view utf8,
                  Style style = {},
                  int width = 100000);
  void fill(const Rect& rect, char32_t glyph, Style style = {});
  void box(const Rect& rect, std::string_view title, Style style = {});
  /// Where clicks mean something; the last one put there counts.
  void zone(const Zone& zone) { zones_.push_back(zone); }
  [[nodiscard]] const Zone* zone_at(int x, int y) const;
  /// What is drawn in there so far is the pane of that number.
  void name_pane(const Rect& rect, std::size_t number);
  /// Lies under the glyphs; a blank that is put over it later takes it away
  /// there, but for those between words.
  void add(const PixelPicture& picture);
  [[nodiscard]] const std::vector<PixelPicture>& pictures() const {
    return pictures_;
  }
  /// Copies another screen's cells, pictures and zones to (x, y).
  void place(int x, int y, const Screen& other);

  /// Rows ended by '\n', without trailing spaces.
  [[nodiscard]] std::string to_text() const;

 private:
  void set(int x, int y, const Cell& cell);
  /// Where there is a blank, pictures end.
  void cover(int x, int y);
  [[nodiscard]] Cell& cell(int x, int y);

  int width_;
  int height_;
  bool ascii_;
  Drawings* drawings_ = nullptr;
  CellPixels pixels_;
  std::vector<Cell> cells_;
  std::vector<PixelPicture> pictures_;
  std::vector<Zone> zones_;
};

}  // namespace tapfit::tui
