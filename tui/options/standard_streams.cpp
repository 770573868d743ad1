#include "tui/options/standard_streams.hpp"

#include "acquisition/foundation/input_error.hpp"
#include "acquisition/foundation/utf8.hpp"

#include <cstdio>
#include <string>

namespace tapfit::tui {

// Not fmt::print, which throws.
void say(std::string_view text) {
  (void)std::fwrite(text.data(), 1, text.size(), stderr);
  (void)std::fflush(stderr);
}

void print(std::string_view result) {
  const std::string text = acquisition::printable(result);
  const std::size_t written = std::fwrite(text.data(), 1, text.size(), stdout);
  if (std::fflush(stdout) == 0 && written == text.size()) return;
  throw InputError("cannot be written",
                   "standard output",
                   "see where it leads to, and the space left there");
}

}  // namespace tapfit::tui
