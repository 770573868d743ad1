#include "tui/screen/terminal_kind.hpp"

#include <term.h>
#include <unistd.h>

namespace tapfit::tui {

bool is_known_terminal(const char* kind) {
  int fault = 0;
  if (setupterm(kind, STDOUT_FILENO, &fault) != 0) return false;
  del_curterm(cur_term);
  return true;
}

}  // namespace tapfit::tui
