// GRDSET, BAROR and BEAMOR: what GRID, CBAR and CBEAM cards take for the fields
// that they leave blank.
//
// Source: MSC Nastran Quick Reference Guide, entries of these names.
#pragma once

#include "updating/structure/cards/bulk_cards.hpp"

#include <string>

namespace tapfit::structure {

/// Whether the card gives defaults.
[[nodiscard]] bool is_default_card(const std::string& name);

/// Fills the blank fields. The orientation of a bar, fields 6 to 8, is taken as
/// a whole.
/// @throws InputError for a second card of the same defaults
void fill_defaults(BulkData& bulk);

}  // namespace tapfit::structure
