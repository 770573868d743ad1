// Which places are next to a place: a climb goes from one to the next.
#pragma once

#include "updating/places/location.hpp"
#include "updating/structure/deck/deck.hpp"

#include <algorithm>
#include <vector>

namespace tapfit::updating {

/// Whether two lists of grids, elements or channels have one in common.
template <class Id>
[[nodiscard]] bool share(const std::vector<Id>& a, const std::vector<Id>& b) {
  return std::ranges::any_of(
      a, [&b](const Id& id) { return std::ranges::find(b, id) != b.end(); });
}

/// Places that are most like one, itself first: the nearest grids, the nearest
/// seams, or the patches that share most elements and, of each other size up to
/// eight times as large or small, the two that do.
///
/// @param places of the effect
/// @param count how many besides itself, at most; not counting other sizes
[[nodiscard]] std::vector<Location> places_near(
    const Location& at,
    const std::vector<Location>& places,
    const structure::Deck& deck,
    int count);

/// Whether a climb from one place would look at the other anyway.
[[nodiscard]] bool within_reach(const Location& from,
                                const Location& to,
                                const std::vector<Location>& places,
                                const structure::Deck& deck,
                                int neighbours);

}  // namespace tapfit::updating
