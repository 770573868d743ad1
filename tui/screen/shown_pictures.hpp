// The pictures that a terminal shows: what has to be sent so that they are
// those of a screen.
#pragma once

#include "tui/screen/palette.hpp"
#include "tui/screen/screen.hpp"
#include "tui/screen/terminal_graphics.hpp"

#include <optional>
#include <string>
#include <vector>

namespace tapfit::tui {

class ShownPictures {
 public:
  /// @pre the graphics are not None
  ShownPictures(Graphics graphics, const Inks& inks)
      : graphics_(graphics), inks_(inks) {}

  struct Change {
    std::vector<int> rows;  ///< of cells to be written anew first, ascending
    std::string sequence;   ///< to be sent once the cells are written
  };
  /// What makes the pictures those of the screen.
  [[nodiscard]] Change show(const Screen& screen);

  /// The terminal has lost them, or is to: what takes the last ones away.
  [[nodiscard]] std::string remove();

 private:
  struct Placed {
    PixelPicture picture;
    unsigned id = 0;
  };

  [[nodiscard]] bool changed(const Screen& screen, int x, int y) const;
  /// Of the terminal, where cells or pictures are not as they are to be.
  [[nodiscard]] std::vector<bool> changed_rows(
      const Screen& screen, const std::vector<Placed>& placed) const;
  [[nodiscard]] Change show_kitty(const Screen& screen);
  [[nodiscard]] Change show_sixel(const Screen& screen);

  Graphics graphics_;
  Inks inks_;
  std::vector<Placed> placed_;
  std::optional<Screen> last_;  ///< shown; empty: the terminal shows nothing
  unsigned last_id_ = 0;
};

}  // namespace tapfit::tui
