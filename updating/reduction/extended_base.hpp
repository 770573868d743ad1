// A reduced base with a few vectors more, and in other coordinates.
//
//   [V R]' A [V R],   R what the further vectors have beyond V
#pragma once

#include "updating/reduction/base_matrices.hpp"
#include "updating/reduction/corrections.hpp"
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
/// @param corrections the last of the fixed base's parts
/// @return with a term for each of released.scaled; its K is diagonal
[[nodiscard]] ReducedBase extended_base(
    const Eigen::MatrixXd& V,
    const ReducedBase& fixed,
    const Eigen::MatrixXd& extra,
    const ReleasedSystem& released,
    const std::vector<CorrectionPart>& corrections);

}  // namespace tapfit::updating
