// A reduced base with a few vectors more.
//
//   [V R]' A [V R],   R what the further vectors have beyond V
//
// Where degrees of freedom are held besides, of this what leaves them at rest.
#pragma once

#include "updating/corrections/corrections.hpp"
#include "updating/reduction/base_matrices.hpp"
#include "updating/reduction/released_system.hpp"

#include <Eigen/Core>

#include <vector>

namespace tapfit::updating {

/// Only products with the new vectors are taken in the large space; what is
/// known of the fixed ones is kept.
/// @param V n x r, M-orthonormal
/// @param fixed the model seen through V
/// @param extra released.dofs() x columns
/// @param corrections the last of the fixed base's parts
/// @return with a term for each of released.scaled. Without one K is diagonal;
///   with one the modes are others for all that its parameter may be, and the
///   coordinates are those of V, then those of R, or of what is held what these
///   leave
/// @throws InputError where nothing is left that moves
[[nodiscard]] ReducedBase extended_base(
    const Eigen::MatrixXd& V,
    const ReducedBase& fixed,
    Eigen::MatrixXd extra,
    const ReleasedSystem& released,
    const std::vector<CorrectionPart>& corrections);

}  // namespace tapfit::updating
