// What splitting a mesh does to its modes: their frequencies, and how much each
// point moves in them.
#pragma once

#include <Eigen/Core>

namespace tapfit::updating {

/// Modes of a mesh at the grids that both meshes have, of unit modal mass.
struct MeshModes {
  Eigen::MatrixXd rows;  ///< 6 n_grids x modes
  Eigen::VectorXd hz;
};

/// What has to be added to the modal stiffness and mass of the finer mesh,
/// diag(l) with l = omega^2, and I, for its modes to change as they did when
/// the mesh was split. Where the coarser mesh's modes are Phi B at the grids
/// that both have, Phi the finer one's and A = B^-1,
///
///   K = diag(l) - A' diag(l_coarse) A,   M = I - A' A
struct MeshShift {
  Eigen::MatrixXd K;  ///< modes x modes of the finer mesh [rad^2/s^2]
  Eigen::MatrixXd M;
};

/// Zero in a mode that the coarser mesh does not have.
[[nodiscard]] MeshShift mesh_shift(const MeshModes& finer,
                                   const MeshModes& coarser);

}  // namespace tapfit::updating
