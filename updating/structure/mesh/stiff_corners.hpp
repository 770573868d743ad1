// Corners as solid as they are. Where members meet at an angle, a deck of lines
// and mid-planes lets each bend up to the point where the lines cross. In the
// structure it bends up to the other member's face only:
//
//   k -> k / (1 - s),   s the share of an element's length (of a shell's width)
//                       that lies inside the other members
//
// A bar that ends there ends half the other one's depth, sqrt(3 I / A) of a
// rectangle, before the crossing; it twists up to the crossing, and one that
// goes on bends as before. A shell ends half the other one's thickness before
// the fold, in bending.
// Source: rigid end offsets of frame analysis, e.g. W. McGuire, R. H.
// Gallagher, R. D. Ziemian, "Matrix Structural Analysis", 2nd ed., 2000,
// ch. 13.
#pragma once

#include "updating/structure/deck/deck.hpp"

#include <map>

namespace tapfit::structure {

/// Its name as a correction of the model and in results.
inline constexpr const char* corner_stiffness = "corner-stiffness";

/// Elements that lie partly inside others: id and share s, 0.9 at most.
[[nodiscard]] std::map<int, double> inside_corners(const Deck& deck);

/// The deck with these elements stiffer, on properties and materials of their
/// own; masses stay.
/// @param inside from inside_corners()
[[nodiscard]] Deck with_stiff_corners(Deck deck,
                                      const std::map<int, double>& inside);

}  // namespace tapfit::structure
