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

/// To first order what has to be added to the modal stiffness and mass of the
/// finer mesh, diag(omega^2) and I, for its modes to change as they did when
/// the mesh was split. A mode phi_r that gains delta = sum_k phi_k T_kr turns
/// I into I - T - T' and diag(l) into diag(l + dl) - T' diag(l) - diag(l) T.
struct MeshShift {
  Eigen::MatrixXd K;  ///< modes x modes of the finer mesh [rad^2/s^2]
  Eigen::MatrixXd M;
};

/// Zero in a mode that the coarser mesh does not have.
[[nodiscard]] MeshShift mesh_shift(const MeshModes& finer,
                                   const MeshModes& coarser);

}  // namespace tapfit::updating
