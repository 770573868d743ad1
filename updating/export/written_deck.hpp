// An updated deck written as the files, and in the style, that it came in.
#pragma once

#include "acquisition/foundation/output_rule.hpp"
#include "updating/structure/deck/deck.hpp"
#include "updating/structure/edit/edit_cards.hpp"

#include <array>
#include <filesystem>
#include <string>
#include <vector>

namespace tapfit::updating {

/// Cards of the deck with identified properties in them, and released
/// components out of its constraints, and the cards to be added.
struct UpdatedDeck {
  structure::CardChanges changes;
  std::vector<std::string> added;
  /// As measured: frequency [Hz], ratio of critical.
  std::vector<std::array<double, 2>> damping;
};

struct WrittenDeck {
  std::vector<std::filesystem::path> files;  ///< the deck itself first
  std::vector<std::string> notes;            ///< what they do not hold, and why
};

/// Whether a deck is written as keywords: an Abaqus or CalculiX deck to a file
/// named .inp. To another one it is written as bulk data.
[[nodiscard]] bool as_keywords(const std::filesystem::path& deck,
                               const std::filesystem::path& target);

/// Of a deck with INCLUDE files those in which cards change are written beside
/// the new deck, the others stay where they are. Where that cannot be, and of
/// keywords as bulk data, all stands in one file.
///
/// @throws InputError where the rule does not let it, or something cannot be
///   written
[[nodiscard]] WrittenDeck write_as_read(const structure::Deck& deck,
                                        const UpdatedDeck& updated,
                                        const std::filesystem::path& path,
                                        const acquisition::OutputRule& rule);

}  // namespace tapfit::updating
