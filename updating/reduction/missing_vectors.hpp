// What a base lacks: answers to points that it does not know, and what changes
// of the stiffness make of the structure.
#pragma once

#include "updating/reduction/basis_enrichment.hpp"
#include "updating/reduction/change_range.hpp"
#include "updating/reduction/released_system.hpp"
#include "updating/reduction/stiffness_change.hpp"

#include <Eigen/Core>

#include <vector>

namespace tapfit::updating {

/// @param modes of the structure without the changes
/// @param released the changes' system
/// @param fresh points whose answers the base does not hold, ascending
/// @param seen degrees of freedom that are acted on or measured, see
///   constraint_modes()
/// @return columns over the released degrees of freedom
[[nodiscard]] Eigen::MatrixXd missing_vectors(
    const HeldBase& held,
    const PlainModes& modes,
    const ReleasedSystem& released,
    const std::vector<StiffnessChange>& changes,
    const std::vector<int>& fresh,
    const std::vector<int>& seen);

}  // namespace tapfit::updating
