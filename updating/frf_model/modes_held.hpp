// Modes with degrees of freedom held that the base leaves free, as far as its
// own modes tell: nothing of the large model is solved.
//
// Held are the patterns B of motion there that the band's modes drive; with R
// the flexibility there that lies above the base, the limit of rigid springs in
// Woodbury's formula is
//
//   H_held = H - H B (B' H B + R)^-1 B' H,
//
// the base on springs R^-1. Of what bends, mode n has a frequency as n^2, moves
// at an edge as much as the others and turns as n there: the part of
// sum phi phi' / omega^2 that lies above omega falls as omega^-p, with p = 3/2
// of displacements, 1/2 of rotations and 1 between them. The modes from the
// band's top to four times that, where the base's end, thus tell what follows:
//
//   R = (sum over them of phi phi' / omega^2) / (4^p - 1)
//
// Source: R. H. MacNeal, "A hybrid method of component mode synthesis",
// Computers & Structures 1, 1971, p. 581 (residual flexibility); the rest is
// Richardson's extrapolation.
#pragma once

#include "updating/frf_model/model_modes.hpp"

#include <Eigen/Core>

namespace tapfit::updating {

/// Rows of a base, r columns each.
struct HeldRows {
  Eigen::MatrixXd moved;   ///< of displacements that are held
  Eigen::MatrixXd turned;  ///< of rotations
};

/// Elastic modes that share the band with several others come out to a few
/// percent of their frequency, more where a clamp leaves but one or two.
///
/// @param modes of a base with modes to four times the band
/// @param rows those that cannot move may be among them
/// @param top of the band [rad/s]
[[nodiscard]] BaseModes modes_held(const BaseModes& modes,
                                   const HeldRows& rows,
                                   double top);

}  // namespace tapfit::updating
