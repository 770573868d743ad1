// Motions that a base needs besides its own where the stiffness changes.
//
// Released degrees of freedom q on springs: the structure's answers psi to unit
// q, the others at zero (constraint modes), are A-orthogonal to all that moves
// with q = 0; only inertia couples the two, and the answer to that,
//
//   A^-1 M psi q,   A = K + shift M,
//
// is of those q alone that the band's modes drive. Elements that keep the share
// p of their stiffness S:
//
//   u = (A - (1 - p) S)^-1 S V a
//
// at p = 1 and next to none. A stiffness that is added, p S, the same with -p
// for 1 - p.
// Source: R. R. Craig, A. J. Kurdila, "Fundamentals of Structural Dynamics",
// 2006, ch. 17 (constraint modes); U. Kirsch, "Reanalysis of Structures", 2008
// (combined approximations).
#pragma once

#include "updating/reduction/released_system.hpp"
#include "updating/reduction/residual_flexibility.hpp"
#include "updating/structure/solve/free_motions.hpp"

#include <Eigen/Core>

#include <vector>

namespace tapfit::updating {

/// The base before the change.
struct HeldBase {
  const structure::System& system;
  const structure::FreeMotions& motions;
  const ResidualFlexibility& answers;
  const Eigen::MatrixXd& V;  ///< n x r, M-orthonormal
  const Eigen::VectorXd& K;  ///< r, V' K V is diagonal [rad^2/s^2]
  double shift = 0.0;        ///< of the answers [rad^2/s^2]
  double high_hz = 0.0;      ///< top of the band
};

/// Of what a released system can do and the base cannot. FRFs through a base
/// with them are good to 2e-7 from rigid springs to soft ones (first order in
/// inertia; without it 4e-4 to 1.5e-3).
/// Where many are released, only the patterns that the band moves and the seen
/// points feel (released_patterns.hpp).
/// @param ranges of each released.scaled
/// @param seen degrees of freedom that are acted on or measured; none: any may
///   be, and all patterns count
/// @return released.dofs() x columns
[[nodiscard]] Eigen::MatrixXd constraint_modes(
    const HeldBase& base,
    const ReleasedSystem& released,
    const std::vector<ChangeRange>& ranges = {},
    const std::vector<int>& seen = {});

/// What elements lose, n x n each: see StiffnessTerm.
struct LostMatrices {
  structure::SparseMatrix S;
  structure::SparseMatrix T;  ///< 0 x 0 where they are not thinned
  structure::SparseMatrix N;
};

/// Of elements that soften to a share `least` of their stiffness S. FRFs
/// through a base with them are good to 5e-4 down to 4 % of the stiffness and
/// 5e-5 at half of it.
/// @return n x columns; those of S orthonormal in M, and those of N
[[nodiscard]] Eigen::MatrixXd loss_modes(const HeldBase& base,
                                         const LostMatrices& lost,
                                         double least);

/// Of a stiffness S that is added, of one sign, up to `most` times.
/// @param S a member's under axial force, its parameter [N], below zero where
///   it is pushed
[[nodiscard]] Eigen::MatrixXd added_modes(const HeldBase& base,
                                          const structure::SparseMatrix& S,
                                          double most);

}  // namespace tapfit::updating
