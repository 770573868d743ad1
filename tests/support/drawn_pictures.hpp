// The pixels that a terminal would show of what it is sent: kitty's graphics
// and sixels, decoded as their documentation says.
#pragma once

#include "tui/screen/pixel_picture.hpp"

#include <map>
#include <string>
#include <string_view>
#include <vector>

namespace tapfit::end_to_end {

struct ShownPixel {
  int red = 0;
  int green = 0;
  int blue = 0;
  int cover = 0;  ///< 0 nothing .. 255

  bool operator==(const ShownPixel&) const = default;
};

class DrawnPictures {
 public:
  DrawnPictures() = default;
  DrawnPictures(int columns, int rows, tui::CellPixels cell);

  [[nodiscard]] int width() const { return columns_ * cell_.width; }
  [[nodiscard]] int height() const { return rows_ * cell_.height; }
  [[nodiscard]] tui::CellPixels cell() const { return cell_; }
  /// What is seen, sixels over the others.
  [[nodiscard]] ShownPixel at(int x, int y) const;
  /// How many of kitty's are shown.
  [[nodiscard]] std::size_t placed() const { return placed_.size(); }
  /// Pixels of which at least half is covered.
  [[nodiscard]] int drawn_pixels() const;

  /// What stands between ESC _ G and its end; the cursor is in that cell.
  void take_kitty(std::string_view text, int column, int row);
  /// What stands between ESC P and its end.
  void take_sixel(std::string_view text, int column, int row);
  /// Text was written there, which takes sixels away.
  void write_cell(int column, int row);
  void clear();

 private:
  struct Placed {
    int x = 0;
    int y = 0;
    int width = 0;
    int height = 0;
    std::string rgba;
  };

  void put_sixel(int x, int y, unsigned bits, const ShownPixel& ink);

  int columns_ = 0;
  int rows_ = 0;
  tui::CellPixels cell_;
  std::map<int, Placed> placed_;             ///< by their id
  std::map<std::string, std::string> keys_;  ///< of what is being sent
  std::string data_;
  std::vector<ShownPixel> sixels_;
};

}  // namespace tapfit::end_to_end
