// Numbers that no structure has, whichever its units: they would not stop the
// reader, but the arithmetic that follows.
#pragma once

#include "updating/structure/deck/deck.hpp"

namespace tapfit::structure {

/// @param deck in the units of its file
/// @throws InputError for the first number that is out of all scale: its card,
///   field and value, and what is plausible
void check_number_scales(const Deck& deck);

}  // namespace tapfit::structure
