// Along which axis a bar is thin: that along which it is milled or worn away.
#pragma once

#include "updating/structure/deck/deck.hpp"

#include <array>

namespace tapfit::structure {

/// Of planes 1 and 2, in which bending goes with the cube of the thickness: the
/// softer one. Of a round or square section both, since it may be thinned along
/// either.
[[nodiscard]] std::array<bool, 2> bends_across(const BarProperty& property);

/// Of its stiffness against twist the share b that goes with the thickness
/// itself; the rest goes with its cube. Of a flat section, b = 0; of a square
/// one J = 0.141 w^2 t^2, b = 1 / 2. To first order that is Saint-Venant's
/// J ~ A^4 / (40 (I_1 + I_2)) of solid sections, with I_1 ~ t^3, I_2, A ~ t:
///
///   d ln J / d ln t = 3 - 2 I_1 / (I_1 + I_2),   b = I_1 / (I_1 + I_2)
///
/// Source: S. Timoshenko, J. N. Goodier, "Theory of Elasticity", art. 109.
[[nodiscard]] double twist_by_thickness(const BarProperty& property);

}  // namespace tapfit::structure
