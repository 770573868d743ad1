// Degrees of freedom held that the model leaves free. What they are held with
// are forces; with E their unit vectors and A = K + shift M
//
//   u = V a + psi f + A^-1 M psi f_1,   psi = A^-1 E,   E' u = 0
//
// What the modes V_1 in the band answer is left out of both before they are
// solved for, A^-1 (E - M V_1 V_1' E): of a free structure it is nearly all of
// the answer (inertia relief), and what clamps need of it would be rounding.
// f_1 the few patterns of forces by which the band's modes are held. The
// condition is met exactly, in a basis of what it leaves: nothing is penalised.
// Source: R. H. MacNeal, "A hybrid method of component mode synthesis",
// Computers & Structures 1, 1971, p. 581 (free modes and the answers to forces
// at interfaces that are then held).
#pragma once

#include "updating/reduction/basis_enrichment.hpp"

#include <Eigen/Core>

#include <vector>

namespace tapfit::updating {

/// psi and A^-1 M psi f_1, less what of them lies in V.
/// @param dofs of the system; of those that it holds some may be among them
/// @return n x columns
[[nodiscard]] Eigen::MatrixXd held_modes(const HeldBase& base,
                                         const std::vector<int>& dofs);

/// What is left to coordinates of which nothing may move some rows.
/// @param rows of a base, held x r; those that it cannot move may be among them
/// @return r x fewer, orthonormal: rows times it is zero
[[nodiscard]] Eigen::MatrixXd motions_without(const Eigen::MatrixXd& rows);

}  // namespace tapfit::updating
