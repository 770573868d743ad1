// Sections of PBARL and PBEAML that are put together of plates: what plates
// have in common, and those with closed cells, whose torsion is Bredt's,
//
//   J = 4 A^2 / integral ds/t          of one cell
//   J = 2 sum A_k q_k,   (integral ds/t)_k q_k - sum (ds/t)_kj q_j = 2 A_k
//
// of several, with q_k the shear flow about cell k over G and the rate of
// twist, (ds/t)_kj of the wall that k shares with j.
//
// Source: MSC Nastran Quick Reference Guide, PBARL (shapes and dimensions);
// W. C. Young, Roark's Formulas for Stress and Strain, 7th ed., ch. 10.
#pragma once

#include "updating/structure/deck/deck.hpp"

#include <vector>

namespace tapfit::structure {

/// DIM1 and so on, from 0.
using Dimensions = std::vector<double>;

/// A rectangle of a section: along element z and y, its centre.
struct Plate {
  double width, height, y, z;
};

/// Area and moments about the centroid; the torsion of an open section.
/// @param shear_y, shear_z the shear centre, in the plates' axes
[[nodiscard]] BarProperty composed(const std::vector<Plate>& plates,
                                   double shear_y,
                                   double shear_z);

/// @param d width, height, thickness of top, bottom, left and right wall
[[nodiscard]] BarProperty box1(const Dimensions& d);

/// A hat on a plate.
/// @param d the plate's width, height of all, width of the hat's top, thickness
///   of the hat, of the plate
[[nodiscard]] BarProperty hat1(const Dimensions& d);

/// Two boxes with a wall in common.
/// @param d width, height, to the middle of the middle wall; thickness of the
///   left, middle and right wall, of top and bottom of the left box and of the
///   right one
[[nodiscard]] BarProperty double_box(const Dimensions& d);

}  // namespace tapfit::structure
