// A portal of steel bars that stands on two clamped feet: the structure of the
// virtual hammer test that is made of beams, hit and felt across its plane.
//
//   z                     legs and upper bar 30 mm x 15 mm, the thin side
//   |____________         across the plane; the upper bar overhangs the right
//   |       |             leg, a lower bar ties the legs
//   |_______|
//   |       |
//   /       /    x
#pragma once

#include "updating/structure/deck/deck.hpp"

#include <string>
#include <vector>

namespace tapfit::updating {

inline constexpr const char* portal_title = "Steel portal of bars";

/// The engineer's model: bars of 50 mm, in the plane y = 0.
[[nodiscard]] structure::Deck portal_deck();

/// The same as Nastran bulk data, one card per text, free field.
[[nodiscard]] std::vector<std::string> portal_cards();

}  // namespace tapfit::updating
