// The program in a terminal of its own: a pseudo-terminal whose other end the
// test holds. Keys, a new size, signals in; what is drawn out.
#pragma once

#include "tests/support/drawn_screen.hpp"

#include <chrono>
#include <optional>
#include <string>
#include <sys/types.h>
#include <termios.h>
#include <vector>

namespace tapfit::end_to_end {

struct TerminalSetting {
  int columns = 100;
  int rows = 30;
  std::string kind = "xterm-256color";   ///< of TERM
  std::vector<std::string> environment;  ///< "NAME=value", besides
  tui::Graphics graphics = tui::Graphics::None;
  tui::CellPixels cell = {};         ///< of graphics
  bool answers = true;               ///< what it is, as terminals do
  bool window_tells_pixels = false;  ///< else they are asked for
};

/// One run of the program, started as a shell starts it. What it draws is kept
/// as the bytes it wrote.
class PseudoTerminal {
 public:
  using Clock = std::chrono::steady_clock;

  PseudoTerminal(const std::vector<std::string>& arguments,
                 const TerminalSetting& setting = {});
  ~PseudoTerminal();
  PseudoTerminal(const PseudoTerminal&) = delete;
  PseudoTerminal& operator=(const PseudoTerminal&) = delete;

  void type(const std::string& bytes);
  void resize(int columns, int rows);
  void send(int signal_number);
  /// Continues what was stopped, in the foreground, as "fg" does.
  void resume();
  /// The other end goes away, as when an ssh connection breaks.
  void hang_up();

  /// Reads until the screen shows the text.
  [[nodiscard]] bool shows(const std::string& text,
                           std::chrono::milliseconds within);
  /// Reads until the bytes have been written.
  [[nodiscard]] bool wrote(const std::string& bytes,
                           std::chrono::milliseconds within);
  /// The same after the first so many bytes, as of bytes().
  [[nodiscard]] bool wrote_since(std::size_t first,
                                 const std::string& bytes,
                                 std::chrono::milliseconds within);
  [[nodiscard]] std::size_t bytes() const { return read_.size(); }
  /// Reads until pictures have at least so many pixels ...
  [[nodiscard]] bool draws(int pixels, std::chrono::milliseconds within);
  /// ... or at most.
  [[nodiscard]] bool draws_at_most(int pixels,
                                   std::chrono::milliseconds within);
  [[nodiscard]] const DrawnScreen& screen() const { return screen_; }

  /// Stopped as by Ctrl-Z, within the time.
  [[nodiscard]] bool stops(std::chrono::milliseconds within);
  /// The status as of waitpid(), empty when it has not ended in time.
  [[nodiscard]] std::optional<int> ends(std::chrono::milliseconds within);

  [[nodiscard]] pid_t program() const { return program_; }

  /// Line modes of the terminal as they are now.
  [[nodiscard]] termios modes() const;
  /// And as they were before the program began.
  [[nodiscard]] const termios& modes_before() const { return before_; }

 private:
  template <class Done>
  bool read_until(const Done& done, std::chrono::milliseconds within);
  bool take(std::chrono::milliseconds within);
  std::optional<int> change(std::chrono::milliseconds within);

  int end_ = -1;   ///< the test's end
  int line_ = -1;  ///< the program's, kept open so that modes can be read
  pid_t shell_ = -1;
  pid_t program_ = -1;
  int told_ = -1;    ///< what the shell has to tell of the program
  int orders_ = -1;  ///< and what it is to do
  termios before_{};
  std::string read_;
  TerminalSetting setting_;
  DrawnScreen screen_;
};

/// Whether echo, line editing, signals and output processing are alike.
[[nodiscard]] bool same_modes(const termios& a, const termios& b);

}  // namespace tapfit::end_to_end
