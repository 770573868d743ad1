// How stiff is stiff: what the parameters of a change may be.
//
// To first order springs of stiffness k per metre in place of a support lower
// omega_r^2 by sum_i f_i^2 / (k length_i), f what the rigid structure's mode r
// asks of them.
//
// To first order p S raises a mode's omega^2 by p phi' S phi. Where S is below
// zero the structure buckles at the least p with K u = -p S u.
#pragma once

#include "updating/reduction/released_system.hpp"
#include "updating/structure/solve/sparse_matrix.hpp"
#include "updating/structure/solve/system.hpp"

#include <Eigen/Core>

namespace tapfit::updating {

/// Of the structure without the change.
struct PlainModes {
  const Eigen::MatrixXd& shapes;  ///< n x count, of unit mass
  const Eigen::VectorXd& hz;
  double high_hz = 0.0;  ///< top of the band
};

/// From a hinge to what no mode in the band feels. Springs that several
/// parameters share have their whole length.
/// @param T what follows rigid elements; 0 x 0: nothing does
[[nodiscard]] ChangeRange spring_range(const ReleasedSystem& released,
                                       const ScaledStiffness& own,
                                       const PlainModes& modes,
                                       const structure::SparseMatrix& T);

/// From 1e-4 to 10 times what doubles omega^2 of the mode in the band that
/// rises most; of what softens, up to 0.9 of what buckles the structure, as the
/// modes have it.
[[nodiscard]] ChangeRange added_range(const structure::SparseMatrix& S,
                                      const PlainModes& modes);

/// Stiffness that elements keep, from all of it to next to none.
inline constexpr ChangeRange loss_range = {1.0, 1.0, 0.04, 0.4, 1.0};

/// What the parameter of a change of this kind may be.
/// @param system of the deck
[[nodiscard]] ChangeRange range_of(const ReleasedSystem& released,
                                   const ScaledStiffness& own,
                                   ChangeKind kind,
                                   const PlainModes& modes,
                                   const structure::System& system);

}  // namespace tapfit::updating
