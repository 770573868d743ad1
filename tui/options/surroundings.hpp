// Where the program runs: its terminal, locale, cache, memory and cores.
#pragma once

#include "tui/screen/terminal_traits.hpp"

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>

namespace tapfit::tui {

struct Surroundings {
  TerminalTraits terminal;
  bool no_colour = false;  ///< NO_COLOR
  bool in_tmux = false;    ///< TMUX
  bool utf8 = false;
  std::string locale;  ///< LC_ALL, LC_CTYPE or LANG, the first that is set
  std::optional<std::filesystem::path> cache;  ///< empty: none is kept
  bool cache_writable = false;
  std::uintmax_t cache_bytes = 0;
  double memory_bytes = 0.0;  ///< that this process may have; 0: not known
  double free_bytes = 0.0;    ///< of these not in use
  unsigned threads = 1;       ///< cores that it may use
  std::string omp_threads;    ///< OMP_NUM_THREADS
};

[[nodiscard]] Surroundings look_around();

}  // namespace tapfit::tui
