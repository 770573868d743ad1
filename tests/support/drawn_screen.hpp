// What a terminal would show: the bytes a program writes, as rows of text, and
// pictures where it has graphics. Knows the sequences that ncurses uses for
// xterm and its like (ECMA-48); colours are left away.
#pragma once

#include "tests/support/drawn_pictures.hpp"
#include "tui/screen/terminal_graphics.hpp"

#include <string>
#include <string_view>
#include <vector>

namespace tapfit::end_to_end {

class DrawnScreen {
 public:
  /// @param cell its pixels, where there are graphics
  DrawnScreen(int columns,
              int rows,
              tui::Graphics graphics = tui::Graphics::None,
              tui::CellPixels cell = {})
      : graphics_(graphics), cell_(cell) {
    resize(columns, rows);
  }

  /// Cut or filled up with blanks, as terminals do.
  void resize(int columns, int rows);
  void take(std::string_view bytes);
  /// Rows ended by '\n', in UTF-8.
  [[nodiscard]] std::string text() const;
  [[nodiscard]] bool shows(const std::string& words) const {
    return text().find(words) != std::string::npos;
  }
  [[nodiscard]] const DrawnPictures& pictures() const { return pictures_; }
  /// What it would say to questions since the last call.
  [[nodiscard]] std::string take_answers();

 private:
  void byte(unsigned char c);
  void control(unsigned char c);
  void glyph(char32_t code);
  void sequence(char last);
  /// What stood between ESC _ or ESC P and its end.
  void string(char kind, const std::string& text);
  void answer_what_it_is();
  void move(int x, int y);
  void erase_in_line(int how);
  void erase_below(int how);
  /// Sixels in these columns of the cursor's row are gone.
  void write_over(std::size_t from, std::size_t end);
  void scroll(int top, int lines);
  [[nodiscard]] int parameter(std::size_t i, int otherwise) const;

  enum class State { Text, Escape, Sequence, Title, String, Skip };
  State state_ = State::Text;
  std::string parameters_;
  char32_t code_ = 0;
  int more_ = 0;  ///< bytes of a UTF-8 glyph still to come
  char32_t last_ = U' ';
  int x_ = 0;
  int y_ = 0;
  int top_ = 0;  ///< of the scrolled stretch
  int bottom_ = 0;
  int kept_x_ = 0;
  int kept_y_ = 0;
  std::vector<std::u32string> rows_;
  tui::Graphics graphics_;
  tui::CellPixels cell_;
  DrawnPictures pictures_;
  char kind_ = 0;  ///< of the string that comes in
  std::string string_;
  std::string answers_;
};

}  // namespace tapfit::end_to_end
