// Places of an effect that a measurement can tell apart.
#pragma once

#include "updating/places/location.hpp"
#include "updating/structure/deck/deck.hpp"

#include <vector>

namespace tapfit::updating {

/// Of places at grids and along lines of grids those that stand for all: as
/// spread_out() has grids of one form, and the middles of lines that run about
/// alike and are about as long.
[[nodiscard]] std::vector<Location> told_apart(
    const std::vector<Location>& places, const structure::Deck& deck);

}  // namespace tapfit::updating
