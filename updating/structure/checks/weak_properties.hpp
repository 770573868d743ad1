// Properties in use that lack a stiffness.
#pragma once

#include "updating/structure/deck/deck.hpp"

#include <string>
#include <vector>

namespace tapfit::structure {

/// One sentence per kind of bending or membrane stiffness that properties in
/// use leave out, naming their cards.
[[nodiscard]] std::vector<std::string> weak_property_warnings(const Deck& deck);

}  // namespace tapfit::structure
