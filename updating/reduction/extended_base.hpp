// A reduced base with a few vectors more, and in other coordinates.
//
//   [V R]' A [V R],   R what the further vectors have beyond V
//
// Where degrees of freedom are held besides, of this what leaves them at rest.
#pragma once

#include "updating/reduction/base_matrices.hpp"
#include "updating/reduction/mesh_factors.hpp"
#include "updating/reduction/released_system.hpp"

#include <Eigen/Core>

#include <vector>

namespace tapfit::updating {

/// Other coordinates of the same span: V Q.
void turn(ReducedBase& base, const Eigen::MatrixXd& Q);

/// Only products with the new vectors are taken in the large space; what is
/// known of the fixed ones is kept.
/// @param V n x r, M-orthonormal
/// @param fixed the model seen through V
/// @param extra released.dofs() x columns
/// @param of_mesh the last of the fixed base's parts
/// @return with a term for each of released.scaled; its K is diagonal
/// @throws InputError where nothing is left that moves
[[nodiscard]] ReducedBase extended_base(const Eigen::MatrixXd& V,
                                        const ReducedBase& fixed,
                                        const Eigen::MatrixXd& extra,
                                        const ReleasedSystem& released,
                                        const std::vector<MeshFactor>& of_mesh);

}  // namespace tapfit::updating
