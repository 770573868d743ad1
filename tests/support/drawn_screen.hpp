// What a terminal would show: the bytes a program writes, as rows of text.
// Knows the sequences that ncurses uses for xterm and its like (ECMA-48);
// colours are left away.
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace tapfit::end_to_end {

class DrawnScreen {
 public:
  DrawnScreen(int columns, int rows) { resize(columns, rows); }

  /// Cut or filled up with blanks, as terminals do.
  void resize(int columns, int rows);
  void take(std::string_view bytes);
  /// Rows ended by '\n', in UTF-8.
  [[nodiscard]] std::string text() const;
  [[nodiscard]] bool shows(const std::string& words) const {
    return text().find(words) != std::string::npos;
  }

 private:
  void byte(unsigned char c);
  void control(unsigned char c);
  void glyph(char32_t code);
  void sequence(char last);
  void move(int x, int y);
  void erase_in_line(int how);
  void erase_below(int how);
  void scroll(int top, int lines);
  [[nodiscard]] int parameter(std::size_t i, int otherwise) const;

  enum class State { Text, Escape, Sequence, Title, Skip };
  State state_ = State::Text;
  std::string parameters_;
  char32_t code_ = 0;
  int more_ = 0;  ///< bytes of a UTF-8 glyph still to come
  char32_t last_ = U' ';
  int x_ = 0;
  int y_ = 0;
  int top_ = 0;  ///< of the scrolled stretch
  int bottom_ = 0;
  std::vector<std::u32string> rows_;
};

}  // namespace tapfit::end_to_end
