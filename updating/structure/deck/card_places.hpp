// Where in its file a card of the deck is, for messages: the file is read
// again, so that the model need not carry the lines of all its cards.
#pragma once

#include "updating/structure/deck/deck.hpp"

#include <set>
#include <string>

namespace tapfit::structure {

/// "file:line NAME id" of the first card of one of the names with this id.
/// @return empty when the deck is from no file or has no such card
[[nodiscard]] std::string card_where(const Deck& deck,
                                     const std::set<std::string>& names,
                                     int id);

/// "GRID id (file:line)", without the line where it is not known.
[[nodiscard]] std::string grid_place(const Deck& deck, int id);

}  // namespace tapfit::structure
