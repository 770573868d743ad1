#include "tui/screen/terminal_signals.hpp"

#include "tui/screen/kitty_graphics.hpp"

#include <array>
#include <csignal>
#include <termios.h>
#include <unistd.h>

namespace tapfit::tui {
namespace {

// Signal handlers can reach nothing but globals.
volatile std::sig_atomic_t end_asked = 0;
volatile std::sig_atomic_t pictures_shown = 0;
volatile std::sig_atomic_t continued = 0;
termios saved_modes{};

void take_end(int) { end_asked = 1; }
void take_continuation(int) { continued = 1; }

template <std::size_t Size>
void write_text(const char (&text)[Size]) {
  const ssize_t written = write(STDOUT_FILENO, text, Size - 1);
  (void)written;
}

/// A crash must not leave a dead terminal: no pictures, shown cursor, main
/// screen, no mouse reports, plain colours, the line modes of before; then die
/// of it.
void restore_and_die(int signal_number) {
  if (pictures_shown != 0) write_text(kitty_removal_of_all);
  write_text(
      "\033[?1000l\033[?1002l\033[?1006l\033[?1049l\033[?25h\033[0m\r\n");
  tcsetattr(STDIN_FILENO, TCSANOW, &saved_modes);
  std::signal(signal_number, SIG_DFL);
  raise(signal_number);
}

constexpr std::array<int, 4> crashes{SIGSEGV, SIGFPE, SIGILL, SIGABRT};
constexpr std::array<int, 4> endings{SIGTERM, SIGHUP, SIGINT, SIGQUIT};

void set_handler(int signal_number, void (*handler)(int)) {
  struct sigaction action {};
  action.sa_handler = handler;
  sigemptyset(&action.sa_mask);
  sigaction(signal_number, &action, nullptr);
}

void (*handler_of(int signal_number))(int) {
  struct sigaction action {};
  sigaction(signal_number, nullptr, &action);
  return action.sa_handler;
}

// Readers of mapped files answer SIGBUS, and abort where they cannot: theirs
// stays, whether it was there before the screens or came while they were.
void take_bus_error() {
  if (handler_of(SIGBUS) == SIG_DFL) set_handler(SIGBUS, restore_and_die);
}

void give_back_bus_error() {
  if (handler_of(SIGBUS) == restore_and_die) set_handler(SIGBUS, SIG_DFL);
}

}  // namespace

void keep_modes() { tcgetattr(STDIN_FILENO, &saved_modes); }

void restore_modes() { tcsetattr(STDIN_FILENO, TCSANOW, &saved_modes); }

void take_signals(bool pictures) {
  end_asked = 0;
  pictures_shown = pictures ? 1 : 0;
  for (const int ending : endings) set_handler(ending, take_end);
  for (const int crash : crashes) set_handler(crash, restore_and_die);
  set_handler(SIGCONT, take_continuation);
  take_bus_error();
}

void give_signals_back() {
  give_back_bus_error();
  set_handler(SIGCONT, SIG_DFL);
  for (const int crash : crashes) set_handler(crash, SIG_DFL);
  for (const int ending : endings) set_handler(ending, SIG_DFL);
}

bool end_was_asked() { return end_asked != 0; }

void ask_to_end() { end_asked = 1; }

bool was_continued() {
  const bool was = continued != 0;
  continued = 0;
  return was;
}

}  // namespace tapfit::tui
