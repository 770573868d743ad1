#include "tests/support/drawn_screen.hpp"

#include "tui/screen/text.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cstdlib>
#include <tuple>
#include <utility>

namespace tapfit::end_to_end {
namespace {

int count(const std::vector<std::u32string>& rows) {
  return static_cast<int>(rows.size());
}

}  // namespace

void DrawnScreen::resize(int columns, int rows) {
  rows_.resize(static_cast<std::size_t>(rows));
  for (std::u32string& row : rows_) {
    row.resize(static_cast<std::size_t>(columns), U' ');
  }
  top_ = 0;
  bottom_ = rows - 1;
  pictures_ = DrawnPictures(columns, rows, cell_);
  move(x_, y_);
}

std::string DrawnScreen::take_answers() { return std::exchange(answers_, {}); }

std::string DrawnScreen::text() const {
  std::string text;
  for (const std::u32string& row : rows_) {
    for (const char32_t glyph : row) tui::append_utf8(text, glyph);
    text += '\n';
  }
  return text;
}

void DrawnScreen::take(std::string_view bytes) {
  for (const char c : bytes) byte(static_cast<unsigned char>(c));
}

void DrawnScreen::move(int x, int y) {
  x_ = std::clamp(x, 0, static_cast<int>(rows_[0].size()) - 1);
  y_ = std::clamp(y, 0, count(rows_) - 1);
}

void DrawnScreen::byte(unsigned char c) {
  if (state_ == State::Skip) {
    state_ = State::Text;
  } else if (state_ == State::Title) {
    if (c == 7 || c == '\\') state_ = State::Text;
  } else if (state_ == State::String) {
    string_ += static_cast<char>(c);
    if (!string_.ends_with("\033\\")) return;
    state_ = State::Text;
    string(kind_, string_.substr(0, string_.size() - 2));
  } else if (state_ == State::Escape) {
    parameters_.clear();
    string_.clear();
    kind_ = static_cast<char>(c);
    state_ = c == '['               ? State::Sequence
             : c == ']'             ? State::Title
             : c == '_' || c == 'P' ? State::String
             : c == '(' || c == ')' ? State::Skip
                                    : State::Text;
    if (c == 'M') scroll(top_, -1);
    if (c == '7') std::tie(kept_x_, kept_y_) = std::pair(x_, y_);
    if (c == '8') move(kept_x_, kept_y_);
  } else if (state_ == State::Sequence) {
    if (c >= 0x40) {
      state_ = State::Text;
      sequence(static_cast<char>(c));
    } else {
      parameters_ += static_cast<char>(c);
    }
  } else if (c < 0x20) {
    control(c);
  } else if (c < 0x80) {
    glyph(c);
  } else if (c >= 0xC0) {
    more_ = c >= 0xF0 ? 3 : c >= 0xE0 ? 2 : 1;
    code_ = c & (0x3FU >> static_cast<unsigned>(more_));
  } else if (more_ > 0) {
    code_ = (code_ << 6U) | (c & 0x3FU);
    if (--more_ == 0) glyph(code_);
  }
}

void DrawnScreen::control(unsigned char c) {
  if (c == 27) {
    state_ = State::Escape;
  } else if (c == '\r') {
    x_ = 0;
  } else if (c == '\b') {
    move(x_ - 1, y_);
  } else if (c == '\t') {
    move(x_ / 8 * 8 + 8, y_);
  } else if (c == '\n') {
    if (y_ == bottom_) {
      scroll(top_, 1);
    } else {
      move(x_, y_ + 1);
    }
  }
}

void DrawnScreen::string(char kind, const std::string& text) {
  if (kind == 'P' && graphics_ == tui::Graphics::Sixel) {
    return pictures_.take_sixel(text, x_, y_);
  }
  if (graphics_ != tui::Graphics::Kitty || !text.starts_with('G')) return;
  if (text.find("a=q") != text.npos) answers_ += "\033_Gi=31;OK\033\\";
  pictures_.take_kitty(text.substr(1), x_, y_);
}

void DrawnScreen::answer_what_it_is() {
  answers_ +=
      graphics_ == tui::Graphics::Sixel ? "\033[?62;4;22c" : "\033[?62;22c";
}

void DrawnScreen::glyph(char32_t code) {
  pictures_.write_cell(x_, y_);
  rows_[static_cast<std::size_t>(y_)][static_cast<std::size_t>(x_)] = code;
  last_ = code;
  move(x_ + 1, y_);
}

int DrawnScreen::parameter(std::size_t i, int otherwise) const {
  std::size_t at = 0;
  for (; i > 0; --i) {
    at = parameters_.find(';', at);
    if (at == std::string::npos) return otherwise;
    ++at;
  }
  const int value = std::atoi(parameters_.c_str() + at);
  return value > 0 ? value : otherwise;
}

void DrawnScreen::erase_in_line(int how) {
  std::u32string& row = rows_[static_cast<std::size_t>(y_)];
  const auto at = row.begin() + x_;
  const auto from = how == 0 ? at : row.begin();
  const auto end = how == 1 ? at + 1 : row.end();
  std::fill(from, end, U' ');
  write_over(static_cast<std::size_t>(from - row.begin()),
             static_cast<std::size_t>(end - row.begin()));
}

void DrawnScreen::write_over(std::size_t from, std::size_t end) {
  for (std::size_t x = from; x < end; ++x) {
    pictures_.write_cell(static_cast<int>(x), y_);
  }
}

void DrawnScreen::erase_below(int how) {
  erase_in_line(how);
  for (int y = 0; y < count(rows_); ++y) {
    if (y == y_ || (how == 0 && y < y_) || (how == 1 && y > y_)) continue;
    rows_[static_cast<std::size_t>(y)].assign(rows_[0].size(), U' ');
    for (int x = 0; x < static_cast<int>(rows_[0].size()); ++x) {
      pictures_.write_cell(x, y);
    }
  }
  if (how == 2) pictures_.clear();
}

/// Rows from `top` to the stretch's bottom move up by that many.
void DrawnScreen::scroll(int top, int lines) {
  const auto first = rows_.begin() + top;
  const auto end = rows_.begin() + bottom_ + 1;
  const auto by = std::min<std::ptrdiff_t>(std::abs(lines), end - first);
  const std::u32string blank(rows_[0].size(), U' ');
  if (lines > 0) {
    std::rotate(first, first + by, end);
    std::fill(end - by, end, blank);
  } else {
    std::rotate(first, end - by, end);
    std::fill(first, first + by, blank);
  }
}

void DrawnScreen::sequence(char last) {
  const int n = parameter(0, 1);
  std::u32string& row = rows_[static_cast<std::size_t>(y_)];
  const auto x = static_cast<std::size_t>(x_);
  const std::size_t many =
      std::min(static_cast<std::size_t>(n), row.size() - x);
  switch (last) {
    case 'H':
      return move(parameter(1, 1) - 1, n - 1);
    case 'A':
      return move(x_, y_ - n);
    case 'B':
      return move(x_, y_ + n);
    case 'C':
      return move(x_ + n, y_);
    case 'D':
      return move(x_ - n, y_);
    case 'G':
      return move(n - 1, y_);
    case 'd':
      return move(x_, n - 1);
    case 'J':
      return erase_below(parameter(0, 0));
    case 'K':
      return erase_in_line(parameter(0, 0));
    case 'X':
      row.replace(x, many, many, U' ');
      return write_over(x, x + many);
    case 'P':
      row.erase(x, many).append(many, U' ');
      return write_over(x, row.size());
    case '@':
      row.insert(x, many, U' ').resize(rows_[0].size());
      return write_over(x, row.size());
    case 'L':
      return scroll(y_, -n);
    case 'M':
      return scroll(y_, n);
    case 'S':
      return scroll(top_, n);
    case 'T':
      return scroll(top_, -n);
    case 'b':
      for (int i = 0; i < n; ++i) glyph(last_);
      return;
    case 'c':
      return answer_what_it_is();
    case 't':
      if (parameters_ == "16" && !cell_.none()) {
        answers_ += fmt::format("\033[6;{};{}t", cell_.height, cell_.width);
      }
      return;
    case 'r':
      top_ = n - 1;
      bottom_ = parameter(1, count(rows_)) - 1;
      return move(0, 0);
    case 'l':  // back to the main screen: what was drawn is gone
      if (parameters_ == "?1049") erase_below(2);
      return;
    default:  // colours and other modes
      return;
  }
}

}  // namespace tapfit::end_to_end
