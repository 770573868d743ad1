// What the mesh does to the modes where these are no longer the base model's: a
// support that gives takes the load off the corners that a mesh is worst at.
#pragma once

#include "updating/frf_model/frf_model.hpp"

#include <cstddef>
#include <memory>

namespace tapfit::updating {

/// The model with its first correction (corrections.hpp) taken from the modes
/// that both meshes have at this state, in place of those without effects.
///
/// @param model of the finer mesh; its base holds that factor
/// @param coarser the same on the deck's own mesh, for the same effects
/// @param factor its position in ModelState::factor
[[nodiscard]] std::shared_ptr<const FrfModel> with_mesh_at(
    const FrfModel& model,
    const FrfModel& coarser,
    const ModelState& state,
    std::size_t factor);

}  // namespace tapfit::updating
