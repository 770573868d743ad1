#include "tui/screen/terminal_graphics.hpp"

#include "tui/screen/graphics_question.hpp"

#include <array>
#include <chrono>
#include <poll.h>
#include <sys/ioctl.h>
#include <termios.h>
#include <unistd.h>

namespace tapfit::tui {
namespace {

using Clock = std::chrono::steady_clock;

constexpr std::chrono::milliseconds patience(300);

// Of what was typed no more is read than ncurses takes back.
constexpr std::size_t most_typed = 100;

/// Keys come at once and are not shown, until it goes.
class KeysAtOnce {
 public:
  KeysAtOnce() {
    tcgetattr(STDIN_FILENO, &before_);
    termios modes = before_;
    modes.c_lflag &= ~static_cast<tcflag_t>(ICANON | ECHO);
    modes.c_cc[VMIN] = 0;
    modes.c_cc[VTIME] = 0;
    tcsetattr(STDIN_FILENO, TCSANOW, &modes);
  }
  ~KeysAtOnce() { tcsetattr(STDIN_FILENO, TCSANOW, &before_); }
  KeysAtOnce(const KeysAtOnce&) = delete;
  KeysAtOnce& operator=(const KeysAtOnce&) = delete;

 private:
  termios before_{};
};

GraphicsAnswer answer_to(const std::string& question) {
  const KeysAtOnce keys;
  if (write(STDOUT_FILENO, question.data(), question.size()) < 0) return {};
  std::string bytes;
  GraphicsAnswer answer;
  const Clock::time_point last = Clock::now() + patience;
  while (!answer.complete && answer.typed.size() < most_typed) {
    const auto left = std::chrono::duration_cast<std::chrono::milliseconds>(
        last - Clock::now());
    pollfd line{STDIN_FILENO, POLLIN, 0};
    if (left.count() <= 0 ||
        poll(&line, 1, static_cast<int>(left.count())) <= 0) {
      break;
    }
    std::array<char, 32> buffer{};
    const ssize_t n = read(STDIN_FILENO, buffer.data(), buffer.size());
    if (n <= 0) break;
    bytes.append(buffer.data(), static_cast<std::size_t>(n));
    answer = read_graphics_answer(bytes);
  }
  return answer;
}

/// None where it can be no cell that is read: some terminals tell others.
CellPixels believed(CellPixels cell) {
  const bool legible = cell.width >= 4 && cell.height >= 8 &&
                       cell.width <= 100 && cell.height <= 200;
  return legible ? cell : CellPixels{};
}

}  // namespace

Graphics TerminalGraphics::best() const {
  if (cell.none()) return Graphics::None;
  return kitty ? Graphics::Kitty : sixel ? Graphics::Sixel : Graphics::None;
}

std::optional<GraphicsWish> graphics_wish(std::string_view word) {
  if (word == "auto") return GraphicsWish::Auto;
  if (word == "kitty") return GraphicsWish::Kitty;
  if (word == "sixel") return GraphicsWish::Sixel;
  if (word == "off") return GraphicsWish::Off;
  return std::nullopt;
}

CellPixels cell_of_window() {
  winsize size{};
  if (ioctl(STDOUT_FILENO, TIOCGWINSZ, &size) != 0) return {};
  if (size.ws_col == 0 || size.ws_row == 0) return {};
  return believed({size.ws_xpixel / size.ws_col, size.ws_ypixel / size.ws_row});
}

TerminalGraphics ask_for_graphics(std::string_view kind) {
  const std::string question = graphics_question(kind);
  if (question.empty()) return {};
  GraphicsAnswer answer = answer_to(question);
  const CellPixels told = cell_of_window();
  return {answer.kitty,
          answer.sixel,
          told.none() ? believed(answer.cell) : told,
          std::move(answer.typed)};
}

}  // namespace tapfit::tui
