// Elements that have lost part of their stiffness (a crack, corrosion, a weld
// heat zone, delamination): their stiffness times a factor, their mass as it
// was; or thinned (a pocket, wear): their bending times the factor, mass and
// membrane times the cube root of it. Where
// it ends within elements, of each layer beside it a factor of its own is left.
#pragma once

#include "updating/places/location.hpp"
#include "updating/structure/deck/deck.hpp"

#include <vector>

namespace tapfit::effects {

/// What is left of the thickness of a plate or a bar, and with it of its mass
/// and membrane, that was thinned until p of its bending stiffness was left:
/// t / t_0 = p^(1/3).
[[nodiscard]] double thickness_left(double p);
/// d thickness_left / d p.
[[nodiscard]] double thickness_left_slope(double p);

/// Elements that each parameter after the first scales: with edges the layers
/// beside its own, else none.
[[nodiscard]] std::vector<std::vector<int>> weakened_beside(
    const updating::Location& where, const structure::Deck& deck);

}  // namespace tapfit::effects
