// Mistakes that the list of test_mistakes.hpp does not hold. They say how the
// check of a test fares with what nobody thought of; four of them have had a
// check of their own since: hum, a machine next door, one signal on two
// channels, a sensor on its side.
#pragma once

#include "tests/updating/support/test_mistakes.hpp"

#include <string>
#include <vector>

namespace tapfit::updating::testing {

/// A mistake, and what a finding can at least point at.
struct UnlistedMistake {
  Mistake mistake;                ///< `words` of its right cause
  std::vector<std::size_t> runs;  ///< it was made in; empty: in all
  std::string channel;            ///< its name; empty: of several
};

[[nodiscard]] const std::vector<UnlistedMistake>& unlisted_mistakes();

/// Whether some finding that is no note is of the runs or of the channel that
/// the mistake was made in, and of no run beside them.
[[nodiscard]] bool is_pointed_at(const UnlistedMistake& mistake,
                                 const std::vector<Finding>& findings);

}  // namespace tapfit::updating::testing
