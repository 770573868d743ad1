// Undamped modes of the model: of the base, and with springs and masses on it.
#pragma once

#include "updating/frf_model/modal_modifications.hpp"
#include "updating/frf_model/model_state.hpp"

#include <Eigen/Core>

#include <vector>

namespace tapfit::updating {

/// In the base's coordinates, of unit mass.
struct BaseModes {
  Eigen::VectorXd omega;  ///< [rad/s]
  Eigen::MatrixXd phi;    ///< r x count
  /// What sits on springs of its own moves, n_own x count; 0 x 0 without any.
  Eigen::MatrixXd own = {};
};

/// @param K, M r x r, M positive definite
/// @param in_modes where M = I and K is diagonal but for rounding beside its
///   largest entries, the coordinates may be taken for the modes
[[nodiscard]] BaseModes solve_modes(const Eigen::MatrixXd& K,
                                    const Eigen::MatrixXd& M,
                                    bool in_modes = true);

/// Stiffness and mass in the coordinates of modes, r x r.
struct ModalMatrices {
  Eigen::MatrixXd K;
  Eigen::MatrixXd M;
};

/// @param modes without the changes
/// @param state has the changes' parameters
[[nodiscard]] ModalMatrices with_changes(
    const BaseModes& modes,
    const std::vector<ModalModification>& changes,
    const ModelState& state);

[[nodiscard]] BaseModes modes_with(
    const BaseModes& modes,
    const std::vector<ModalModification>& changes,
    const ModelState& state);

/// What belonged to the modes of frequencies `from`, given to those of `to` in
/// order of frequency.
[[nodiscard]] std::vector<int> by_order(const std::vector<int>& of,
                                        const Eigen::VectorXd& from,
                                        const Eigen::VectorXd& to);

}  // namespace tapfit::updating
