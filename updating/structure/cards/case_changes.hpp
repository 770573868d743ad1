// What a case control asks for that changes stiffness or mass and is not read:
// a static preload, temperatures of materials, nonstructural mass, matrices of
// dynamic responses.
#pragma once

#include "updating/structure/cards/bulk_cards.hpp"

namespace tapfit::structure {

/// Puts what the model lacks into left_out, and what modes do not see though
/// it looks like it into warnings.
void add_case_changes(BulkData& bulk);

}  // namespace tapfit::structure
