// What the mesh does to a model's FRFs.
#pragma once

#include "updating/frf_model/frf_model.hpp"
#include "updating/residual/residual.hpp"

#include <Eigen/Core>

namespace tapfit::updating {

/// What the mesh may leave of the error of the FRFs where its own factor is
/// fitted, from the same model on a mesh that is one step coarser:
/// half of the difference. What uncertain properties and damping can
/// take up is not counted.
[[nodiscard]] double mesh_error(const FrfModel& finer,
                                const FrfModel& coarser,
                                const ModelState& state,
                                const Target& target);

}  // namespace tapfit::updating
