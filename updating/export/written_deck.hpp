// An updated deck written as the files that it came in.
#pragma once

#include "acquisition/foundation/output_rule.hpp"
#include "updating/structure/deck/deck.hpp"
#include "updating/structure/edit/edit_cards.hpp"

#include <filesystem>
#include <string>
#include <vector>

namespace tapfit::updating {

/// Lines of the deck with identified properties in their cards and released
/// components out of its constraints, and the cards to be added.
struct UpdatedDeck {
  structure::EditedDeck edited;
  std::vector<std::string> added;
};

struct WrittenDeck {
  std::vector<std::filesystem::path> files;  ///< the deck itself first
  std::vector<std::string> notes;            ///< what they do not hold, and why
};

/// Of a deck with INCLUDE files those in which cards change are written beside
/// the new deck, the others stay where they are. Where that cannot be, and of
/// an Abaqus or CalculiX deck, all stands in one file of bulk data.
///
/// @throws InputError where the rule does not let it, or something cannot be
///   written
[[nodiscard]] WrittenDeck write_as_read(const structure::Deck& deck,
                                        UpdatedDeck updated,
                                        const std::filesystem::path& path,
                                        const acquisition::OutputRule& rule);

}  // namespace tapfit::updating
