// Long work that is made of parts as one share that never falls: who watches
// it sees how far the whole is, whatever the parts report of themselves. A
// observer does not go with them, but for observed_part().
#pragma once

#include "acquisition/foundation/progress.hpp"

#include <string>

namespace tapfit::updating {

/// For a part of the work: its 0 .. 1 is from .. to of the whole.
[[nodiscard]] Progress part_of(const Progress& whole, double from, double to);

/// From the second on with the number behind the name of each stage:
/// "screening (rung 2)".
[[nodiscard]] Progress numbered(const Progress& whole,
                                const std::string& what,
                                int number);

/// Passes on no share below one that was passed on before: parts may be done
/// again, and some report each of their fits from 0 to 1.
[[nodiscard]] Progress monotonic(const Progress& whole);

}  // namespace tapfit::updating
