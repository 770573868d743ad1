#include "tui/screen/terminal_traits.hpp"

#include <algorithm>
#include <cstdlib>
#include <poll.h>
#include <sys/ioctl.h>
#include <term.h>
#include <unistd.h>

namespace tapfit::tui {
namespace {

/// Whether it has a capability that is a string.
bool is_able(const char* capability) {
  const char* text = tigetstr(capability);
  return text != nullptr && text != reinterpret_cast<const char*>(-1);
}

bool keys_wait() {
  pollfd line{STDIN_FILENO, POLLIN, 0};
  return poll(&line, 1, 0) > 0;
}

}  // namespace

TerminalTraits look_at_terminal() {
  TerminalTraits traits;
  traits.is_one = isatty(STDIN_FILENO) != 0 && isatty(STDOUT_FILENO) != 0;
  const char* kind = std::getenv("TERM");
  traits.kind = kind != nullptr ? kind : "";
  winsize size{};
  if (ioctl(STDOUT_FILENO, TIOCGWINSZ, &size) == 0) {
    traits.width = size.ws_col;
    traits.height = size.ws_row;
  }
  int fault = 0;
  traits.known = setupterm(nullptr, STDOUT_FILENO, &fault) == 0;
  if (!traits.known) return traits;
  traits.places_cursor = is_able("cup");
  traits.colours = std::max(tigetnum("colors"), 0);
  traits.mouse = is_able("kmous");
  del_curterm(cur_term);
  // What is read with an answer would be lost to the shell.
  if (traits.is_one && !keys_wait()) {
    traits.graphics = ask_for_graphics(traits.kind);
  }
  return traits;
}

bool is_known_terminal(const char* kind) {
  int fault = 0;
  if (setupterm(kind, STDOUT_FILENO, &fault) != 0) return false;
  del_curterm(cur_term);
  return true;
}

}  // namespace tapfit::tui
