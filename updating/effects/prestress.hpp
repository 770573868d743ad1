// A member or strip under axial force: a strut bolted in too short, a plate
// held at both ends that has warmed up, a wire that pulls at an end. It
// stiffens what it pulls and softens what it pushes, in proportion to the
// square of each mode's slope along it (preload.hpp). A member with a loose end
// is pulled by a wire, which holds that end across as well.
#pragma once

#include "updating/places/location.hpp"
#include "updating/structure/deck/deck.hpp"

namespace tapfit::effects {

/// Whether elements make up a member that can be pulled, or pushed, so.
[[nodiscard]] bool can_carry(const structure::Deck& deck,
                             const updating::Location& where);

}  // namespace tapfit::effects
