// What the mesh does to a model's FRFs.
#pragma once

#include "updating/frf_model/frf_model.hpp"
#include "updating/residual/residual.hpp"

#include <Eigen/Core>

namespace tapfit::updating {

/// The share of the error that the mesh causes, from the same model on a mesh
/// that is one step coarser. At clamped edges and inner corners a mesh
/// converges as h, not h^2: the finer one is still off by as much as it differs
/// from the coarser. What uncertain properties and damping can take up is not
/// counted.
///
/// @return the difference as a residual of stack(); its norm is the error
[[nodiscard]] Eigen::VectorXd mesh_error(const FrfModel& finer,
                                         const FrfModel& coarser,
                                         const ModelState& state,
                                         const Target& target);

}  // namespace tapfit::updating
