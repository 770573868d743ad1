// The room updating/structure/edit. A deck's own file with cards changed, taken
// out or added, everything else as written.
// In:  Deck and what is to change.
// Out: Its lines in the style that it came in, bulk data or keywords, and files
//      of them.
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

/// The cards to put for a card; nothing where it stays as it is.
using CardEdit = std::function<std::optional<std::vector<Card>>(const Card&)>;

/// What stands for a card of the deck: none where it is taken out; the card
/// itself first where others are added to it.
struct ChangedCard {
  std::size_t at = 0;  ///< in BulkData::cards
  std::vector<Card> now;
};

struct CardChanges {
  BulkData bulk;  ///< with defaults filled in; of keywords their translation
  std::vector<ChangedCard> changed;
};

/// @param edits the first that replaces a card is taken
/// @throws InputError for a deck that cannot be read
[[nodiscard]] CardChanges change_cards(const std::filesystem::path& deck,
                                       const std::vector<CardEdit>& edits);

/// A deck of which some lines are replaced.
struct EditedDeck {
  std::vector<std::string> lines;  ///< as read, INCLUDE files inlined
  /// By line, what stands in its place.
  std::map<std::size_t, std::vector<std::string>> replaced;
  std::vector<std::string> behind = {};  ///< what comes last

  /// Puts lines in front of one; behind all, where there is none of that
  /// number.
  void add(const std::vector<std::string>& added, std::size_t in_front_of);

  /// What it says, line by line.
  [[nodiscard]] std::vector<std::string> text() const;
};

/// Bulk data: cards stay in their form, small, large or free field. The old
/// lines of a replaced card stay as comments in front of the new ones.
///
/// @param added put in front of ENDDATA
[[nodiscard]] EditedDeck bulk_text(const CardChanges& changes,
                                   const std::vector<std::string>& added = {});

/// bulk_text() of change_cards().
[[nodiscard]] EditedDeck edit_deck(const std::filesystem::path& deck,
                                   const std::vector<CardEdit>& edits);

/// The text of edit_deck().
[[nodiscard]] std::vector<std::string> edit_cards(
    const std::filesystem::path& deck, const std::vector<CardEdit>& edits);

}  // namespace tapfit::structure
