// The stiffness that a structure gets from a member or strip under axial force.
//
// What carries the force is found by statics. A member with a loose end is
// pulled from outside, by a wire: K u = f, f a unit outward at that end. Any
// other is made too short, by the initial force N_0 all along it,
//
//   K u = sum_e int B' N_0,   N_e = N_0 + C_e eps(u),
//
// so that what it is joined to carries the rest and the whole is in balance.
// Then K_g = sum_e N_e K_g,e of all elements, for a unit force across the
// member. A wire also holds its end across by its own T / L_wire.
//
// Source: R. D. Cook et al., "Concepts and Applications of Finite Element
// Analysis", 2002, ch. 18 (stress stiffening).
#pragma once

#include "updating/places/axial_member.hpp"
#include "updating/places/location.hpp"
#include "updating/structure/deck/deck.hpp"
#include "updating/structure/solve/system.hpp"

#include <optional>
#include <vector>

namespace tapfit::effects {

/// Of Where::variant.
[[nodiscard]] bool is_compression(const updating::Location& where);

/// The member at a place. @param elements that stand there on this deck
[[nodiscard]] std::optional<updating::AxialMember> member_at(
    const structure::Deck& deck,
    const std::vector<int>& elements,
    const updating::Location& where);

struct Preload {
  structure::SparseMatrix along;  ///< of a unit force, below zero if it pushes
                                  ///< [1/m, 1, m]
  /// Of a unit stiffness across a wire; 0 x 0 where there is no wire.
  structure::SparseMatrix side = {};
};

/// @param deck what is solved
/// @param system its matrices
/// @param elements of the deck, that stand at the place
/// @return zero where the elements make up no member
[[nodiscard]] Preload preload(const structure::Deck& deck,
                              const structure::System& system,
                              const std::vector<int>& elements,
                              const updating::Location& where);

}  // namespace tapfit::effects
