// The room updating/structure/mesh. A mesh with every element split once more,
// and what free edges lack.
// In:  Deck.
// Out: RefinedDeck: the finer deck and where its grids and elements come from.
// May include: its row in CONTRIBUTING.md.
//
// The same deck with every element split once more (a shell into four, a bar
// into two), to learn how much of an error is the mesh's.
#pragma once

#include "updating/structure/mesh/refined_deck.hpp"

namespace tapfit::structure {

/// Whether every element of the deck that the mesh's error comes from can be
/// split: not so for solids and quadratic shells.
[[nodiscard]] bool can_refine(const Deck& deck);

/// Splits every shell and bar of a deck. A new grid on an edge is held, or
/// follows a rigid element, in the components in which both ends of the edge do
/// (along axes between theirs); one in the middle of a shell follows where all
/// corners do. Where elements beside a seam have doubles of its grids, tied and
/// sprung to them, the middles are tied alike and share the springs. Rods and
/// shear panels are kept whole (two in line would be a mechanism), as are
/// solids, quadratic shells and point elements.
[[nodiscard]] RefinedDeck refine_mesh(const Deck& deck);

}  // namespace tapfit::structure
