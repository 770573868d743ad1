// What a written deck says otherwise than the one it was made of, by card.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace tapfit::structure {

/// One card, its fields joined with commas.
struct CardChange {
  std::string card;    ///< "MAT1 1": name and first field
  std::string where;   ///< "model.bdf:12"; of one that is new in the written
  std::string before;  ///< empty: new
  std::string after;   ///< empty: taken out
};

/// In the order of the first deck, what is new behind; cards that say the same
/// in another format or place are none. Of two decks of keywords a card is a
/// keyword with its options, or a line of its data.
///
/// @throws InputError as read_bulk_data()
[[nodiscard]] std::vector<CardChange> card_difference(
    const std::filesystem::path& before, const std::filesystem::path& after);

}  // namespace tapfit::structure
