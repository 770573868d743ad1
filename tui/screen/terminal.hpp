// The terminal, by way of ncurses (included in terminal.cpp only): shows
// screens, reads keys, and always leaves the terminal as it was.
#pragma once

#include "tui/screen/key.hpp"
#include "tui/screen/palette.hpp"
#include "tui/screen/screen.hpp"
#include "tui/screen/terminal_graphics.hpp"

#include <memory>
#include <optional>
#include <string>

namespace tapfit::tui {

struct TerminalOptions {
  Theme theme = Theme::Default;  ///< Mono when NO_COLOR is set and not empty
  bool no_mouse = false;
  bool blocks = false;  ///< quarter blocks stand in for braille dots
  bool light = false;   ///< colours that are seen on a light background
  GraphicsWish graphics = GraphicsWish::Off;
};

/// There is at most one at a time. What other code writes to standard error
/// meanwhile is kept and comes out after the terminal is restored.
class Terminal {
 public:
  /// @throws InputError when standard input or output is no terminal
  explicit Terminal(const TerminalOptions& options);
  ~Terminal();
  Terminal(const Terminal&) = delete;
  Terminal& operator=(const Terminal&) = delete;

  [[nodiscard]] int width() const;
  [[nodiscard]] int height() const;
  /// Of a cell, where it shows pictures; else none.
  [[nodiscard]] CellPixels pixels() const;
  void show(const Screen& screen);
  /// The next key, or nothing within the time.
  [[nodiscard]] std::optional<Key> read_key(int milliseconds);
  /// Names its window, where it has one; the shell's name comes back.
  void name_window(const std::string& title);
  /// Puts text into its clipboard, where it has one.
  void copy(const std::string& text);
  /// Gives the terminal back to the shell until the user takes it up again.
  void suspend();
  /// A signal asked the program to end (TERM, HUP, INT, QUIT), or the
  /// terminal's other end has gone.
  [[nodiscard]] static bool asked_to_end();

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

/// True when the locale's character set is UTF-8. Sets the locale's character
/// type (numbers stay in C) from the environment.
[[nodiscard]] bool locale_is_utf8();

/// The version of ncurses that is in use.
[[nodiscard]] std::string terminal_library();

}  // namespace tapfit::tui
