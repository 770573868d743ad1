// What a newcomer is told on each screen: what is seen there, the keys worth a
// try, and where to go on.
#pragma once

#include "tui/workbench/snapshot.hpp"

#include <cstddef>
#include <string>

namespace tapfit::tui {

/// @param screen from 0
/// @param known as the work stands; before and after a diagnosis, with effects
///   added and without, other words are said
[[nodiscard]] std::string tour_words(std::size_t screen, const Snapshot& known);

}  // namespace tapfit::tui
