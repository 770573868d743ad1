// What the mesh does to a model's FRFs.
#pragma once

#include "updating/frf_model/frf_model.hpp"
#include "updating/residual/residual.hpp"

#include <Eigen/Core>

namespace tapfit::updating {

/// What the mesh leaves of the error where its own factor is fitted, from the
/// same model on a mesh that is one step coarser: half of the difference. Mode
/// by mode the finer one is still off by a third of it where convergence is
/// quadratic and by all of it where it is linear, as h, at clamped edges and
/// inner corners; the factor takes what modes have in common. What uncertain
/// properties and damping can take up is not counted.
///
/// @return as a residual of stack(); its norm is the error
[[nodiscard]] Eigen::VectorXd mesh_error(const FrfModel& finer,
                                         const FrfModel& coarser,
                                         const ModelState& state,
                                         const Target& target);

}  // namespace tapfit::updating
