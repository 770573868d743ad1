// The face by which a clamped edge or section sits in what holds it. Where that
// gives by k per area, a section of area A with second moments C = int xi xi'
// dA about its centroid, which lies at x from the grid, is held by
//
//   S = k [ A I      -A X            ]      X = [x]x, on (u, theta) of the grid
//         [ sym      A X'X + tr(C) - C ]
//
// (Winkler's bed under a rigid section, in all three directions.)
#pragma once

#include "updating/structure/deck/deck.hpp"

#include <Eigen/Core>

#include <map>
#include <vector>

namespace tapfit::updating {

using GridMatrix = Eigen::Matrix<double, 6, 6>;

/// S / k of each grid, along basic axes: sections of bars that end there, and
/// the thickness of shells over half of each edge that lies there.
///
/// @param nodes held grids
/// @return [m^2, m^3, m^4]; of grids with a face alone. None at all where an
///   element is held wholly: then the face is inside the structure
[[nodiscard]] std::map<int, GridMatrix> support_face(
    const structure::Deck& deck, const std::vector<int>& nodes);

/// What the same bed under shells holds against turning of each edge about
/// itself, over k; for an edge of length L and thickness t: L t^3 / 12.
///
/// @param nodes held grids
/// @return [m^4]; 0 where no edge of a shell lies there
[[nodiscard]] double edges_turn(const structure::Deck& deck,
                                const std::vector<int>& nodes);

}  // namespace tapfit::updating
