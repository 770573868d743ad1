// The section of a laminate (PCOMP): the classical one,
//
//   A = sum Q t,  B = sum Q (z1^2 - z0^2) / 2,  D = sum Q (z1^3 - z0^3) / 3
//
// and transverse shear that makes the energy of the shear stresses which go
// with bending along each axis the right one,
//
//   1 / S = 1 / (E I)^2  integral g(z)^2 / G dz,   g' = Q_11 (z_n - z)
//
// (5/6 G t where all plies are alike).
//
// Source: R. M. Jones, "Mechanics of Composite Materials", 2nd ed., ch. 4; MSC
// Nastran Quick Reference Guide, PCOMP.
#pragma once

#include "updating/structure/deck/deck.hpp"
#include "updating/structure/elements/section_matrices.hpp"

namespace tapfit::structure {

/// A laminate whose bending_ratio is zero (LAM = MEM) has no bending stiffness,
/// one of bending_alone (BEND) no other; one whose shear_ratio is zero (SMEAR)
/// has D = A t^2 / 12, no B and no transverse shear, whatever the order of its
/// plies.
///
/// @param p with plies; they are as thick in all as its thickness says, or the
///   shell's
/// @throws InputError when a material has no stiffness
[[nodiscard]] ShellSection laminate_section(const Deck& deck,
                                            const Shell& shell,
                                            const ShellProperty& p);

}  // namespace tapfit::structure
