// The room updating/structure/edit. A deck's own file with cards changed, taken
// out or added, everything else as written.
// In:  Deck and what is to change.
// Out: Lines of bulk data, and files of them.
// May include: its row in CONTRIBUTING.md.
//
// A deck's own cards replaced, everything else left as written.
#pragma once

#include "updating/structure/cards/bulk_cards.hpp"

#include <filesystem>
#include <functional>
#include <map>
#include <optional>
#include <string>
#include <vector>

namespace tapfit::structure {

/// The lines to put for a card; nothing where it stays as it is.
using CardEdit =
    std::function<std::optional<std::vector<std::string>>(const Card&)>;

/// A deck of which some lines are replaced.
struct EditedDeck {
  std::vector<std::string> lines;  ///< as read, INCLUDE files inlined
  /// By line, what stands in its place.
  std::map<std::size_t, std::vector<std::string>> replaced;

  /// What it says, line by line.
  [[nodiscard]] std::vector<std::string> text() const;
};

/// The old lines of a replaced card stay as comments in front of the new ones.
///
/// @param edits the first that replaces a card is taken
/// @throws InputError for a deck that cannot be read
[[nodiscard]] EditedDeck edit_deck(const std::filesystem::path& deck,
                                   const std::vector<CardEdit>& edits);

/// The text of edit_deck().
[[nodiscard]] std::vector<std::string> edit_cards(
    const std::filesystem::path& deck, const std::vector<CardEdit>& edits);

/// A card in large field.
[[nodiscard]] std::vector<std::string> large_field(const Card& card);

}  // namespace tapfit::structure
