// Cards that are written as repetitions of the one before them.
//
//   GRID,101,17,1.0,10.5,,17,3456
//   =,*(1),=,*(0.2),==
//   =(3)
//
// Source: MSC Nastran Quick Reference Guide, "Bulk data entry replication".
#pragma once

#include "updating/structure/cards/card.hpp"

#include <vector>

namespace tapfit::structure {

/// All cards written out: "=" is the field of the card before, "==" all of its
/// fields to the end of the line, or of the card where nothing follows; "*x" or
/// "*(x)" the number there and x more; "=n" or "=(n)" as a name n cards more
/// with the steps of the last. Cards made so are marked as repeated; those of
/// one line share it.
///
/// @throws InputError where there is nothing to repeat, or no number to go on
///   from
[[nodiscard]] std::vector<Card> written_out(std::vector<Card> cards);

}  // namespace tapfit::structure
