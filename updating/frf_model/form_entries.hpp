// Which entries e_ij of the modal stiffness a deck that is wrong in form has
// wrong: see FrfModel::form_patterns().
#pragma once

#include <Eigen/Core>

#include <vector>

namespace tapfit::updating {

/// Two modes that the form mixes, i <= j; i = j: the mode's own stiffness.
struct FormEntry {
  Eigen::Index i = 0;
  Eigen::Index j = 0;
};

/// Of the lowest frequency measured: a mode below is as good as rigid, its
/// stiffness takes less than a third of what its mass does.
inline constexpr double form_below = 0.5;

/// What the mesh still leaves of what splitting it changed, mode by mode:
/// between a third of it, where convergence is quadratic, and all of it, where
/// it is linear, as h, at clamped edges and inner corners. What modes have in
/// common its factor takes; evenly spread between the two, a mode is beside
/// that by (1 - 1/3) / sqrt(12).
inline constexpr double mesh_left_over = 0.19;

/// Each of the first modes with itself and with the next five that show at the
/// points: those across the direction measured are none of its neighbours.
///
/// @param omega of the modes, ascending [rad/s]
/// @param at_points shapes, points x modes
/// @param lowest omega of a mode of which more than its mass shows [rad/s]
/// @param modes how many are the first
[[nodiscard]] std::vector<FormEntry> form_entries(
    const Eigen::VectorXd& omega,
    const Eigen::MatrixXd& at_points,
    double lowest,
    Eigen::Index modes);

}  // namespace tapfit::updating
