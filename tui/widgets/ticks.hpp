// Where an axis has its ticks and what stands beside them.
#pragma once

#include <string>
#include <vector>

namespace tapfit::tui {

struct Tick {
  double value = 0.0;
  std::string label;
};

/// Round values (1, 2, 5 times a power of ten) inside lo..hi.
///
/// @param log powers of ten, or 1, 2, 5 steps where there are few of them
/// @param most largest number of ticks wanted, at least 2; a few more where
///   there would be fewer than two
/// @return empty for an empty, infinite or (log) not positive range
[[nodiscard]] std::vector<Tick> ticks(double lo, double hi, bool log, int most);

/// The same for angles [deg]: quarters, halves of a turn where they fit.
[[nodiscard]] std::vector<Tick> degree_ticks(double lo, double hi, int most);

}  // namespace tapfit::tui
