// The room updating/structure/edit. A deck's own file with cards changed, taken
// out or added, everything else as written.
// In:  Deck and what is to change.
// Out: Lines of bulk data.
// May include: its row in CONTRIBUTING.md.
//
// A deck's own cards replaced, everything else left as written.
#pragma once

#include "updating/structure/cards/bulk_cards.hpp"

#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <vector>

namespace tapfit::structure {

/// The lines to put for a card; nothing where it stays as it is.
using CardEdit =
    std::function<std::optional<std::vector<std::string>>(const Card&)>;

/// @param edits the first that replaces a card is taken
/// @return the deck's lines, INCLUDE files inlined; the old lines of a replaced
///   card stay as comments in front of the new ones
/// @throws InputError for a deck that cannot be read
[[nodiscard]] std::vector<std::string> edit_cards(
    const std::filesystem::path& deck, const std::vector<CardEdit>& edits);

/// A card in large field.
[[nodiscard]] std::vector<std::string> large_field(const Card& card);

}  // namespace tapfit::structure
