// What splitting a mesh does to its modes.
#pragma once

#include <Eigen/Core>

namespace tapfit::updating {

/// Modes of a mesh at the grids that both meshes have.
struct MeshModes {
  Eigen::MatrixXd rows;  ///< 6 n_grids x modes
  Eigen::VectorXd hz;
};

/// omega_r^2 of the finer mesh less that of the same mode of the coarser one
/// [rad^2/s^2]; zero where the coarser one has no such mode.
[[nodiscard]] Eigen::VectorXd mesh_shift(const MeshModes& finer,
                                         const MeshModes& coarser);

}  // namespace tapfit::updating
