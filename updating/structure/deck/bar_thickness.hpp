// Along which axis a bar is thin: that along which it is milled or worn away.
#pragma once

#include "updating/structure/deck/deck.hpp"

#include <array>

namespace tapfit::structure {

/// Of planes 1 and 2, in which bending goes with the cube of the thickness: the
/// softer one. Of a round or square section both, since it may be thinned along
/// either.
[[nodiscard]] std::array<bool, 2> bends_across(const BarProperty& property);

}  // namespace tapfit::structure
