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
  std::string text;      ///< line of the first, how many, the consequence
  bool defines = false;  ///< what other cards refer to
};

/// By name. Cards that only steer a solution are left out.
/// @param passes what the readers understand
[[nodiscard]] std::vector<UnsupportedCard> unsupported_cards(
    const BulkData& bulk, const std::vector<CardTable>& passes);

}  // namespace tapfit::structure
