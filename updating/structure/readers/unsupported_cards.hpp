// Cards of a deck that no reader understands, and what the model lacks without
// them.
#pragma once

#include "updating/structure/cards/bulk_cards.hpp"
#include "updating/structure/readers/deck_builder.hpp"

#include <string>
#include <vector>

namespace tapfit::structure {

/// The cards of one name.
struct UnsupportedCard {
  std::string name;
  std::string where;     ///< "file:line" of the first
  std::string text;      ///< line of the first, how many, the consequence
  bool defines = false;  ///< what other cards refer to
};

struct UnsupportedCards {
  /// Without which the model lacks stiffness, mass or a constraint.
  std::vector<UnsupportedCard> needed;
  std::vector<UnsupportedCard> others;
  /// One sentence on those that change no mode; empty where there are none.
  std::string ignored;
};

/// Cards that only steer a solution are left out.
/// @param passes what the readers understand
[[nodiscard]] UnsupportedCards unsupported_cards(
    const BulkData& bulk, const std::vector<CardTable>& passes);

/// Takes out cards that are read, too, and says so; and of which name there are
/// none.
/// @param ignored names that the user does not want read
/// @param passes what the readers understand
void take_out(const std::vector<std::string>& ignored,
              const std::vector<CardTable>& passes,
              BulkData& bulk);

/// @param ignored names that the user takes upon himself
/// @throws InputError for a needed card of another name
void refuse_needed(const UnsupportedCards& cards,
                   const std::vector<std::string>& ignored);

}  // namespace tapfit::structure
