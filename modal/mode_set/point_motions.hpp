// Shapes as motions of points: components along axes put together.
#pragma once

#include "modal/mode_set/mode_set.hpp"

#include <Eigen/Core>

#include <map>

namespace tapfit::modal {

/// Motion of each node that was measured, along the axes its directions count
/// along; a direction that was not measured stays 0.
/// @param shape as modes.dofs, entries beyond are left out; rotations too
[[nodiscard]] std::map<int, Eigen::Vector3d> point_motions(
    const ModeSet& modes, const Eigen::VectorXd& shape);

/// The factor that brings a shape as near to another as it gets (least
/// squares); 1 where there is nothing to go by.
[[nodiscard]] double factor_onto(const Eigen::VectorXd& other,
                                 const Eigen::VectorXd& shape);

}  // namespace tapfit::modal
