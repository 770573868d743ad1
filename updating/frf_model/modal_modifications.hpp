// Springs and masses that are alike in every run go into the modes, so that
// each mode's damping ratio belongs to the structure as it was hit, with them
// on it: that is the ratio a test sees. Woodbury's formula adds whatever else
// acts on few degrees of freedom; without damping both are the same model.
// See docs/decisions/damping-of-loaded-modes.md.
#pragma once

#include "updating/frf_model/model_state.hpp"
#include "updating/reduction/reduced_base.hpp"

#include <Eigen/Core>

#include <vector>

namespace tapfit::updating {

/// A row of the base: what it moves of a degree of freedom that is acted on.
[[nodiscard]] Eigen::RowVectorXd acted_row(const effects::InterfaceDof& dof,
                                           const structure::Deck& deck,
                                           const ReducedBase& base);

/// What a unit of a parameter adds to the base's matrices, r x r; 0 x 0: none.
struct ModalModification {
  std::size_t effect = 0;     ///< of the state
  std::size_t parameter = 0;  ///< of the effect
  Eigen::MatrixXd dK;         ///< [1/s^2] per unit of the parameter
  Eigen::MatrixXd dM;         ///< per unit of the parameter
};

/// The state's effects without the springs and masses that go into the modes:
/// their parameters are zero.
[[nodiscard]] std::vector<EffectInstance> outside_modal_basis(
    const ModelState& state,
    const effects::TestContext& context,
    const std::vector<std::size_t>& runs);

/// Of every parameter of the state that goes into the modes.
/// @param runs the measured ones
[[nodiscard]] std::vector<ModalModification> modal_modifications(
    const ModelState& state,
    const effects::TestContext& context,
    const std::vector<std::size_t>& runs,
    const ReducedBase& base);

}  // namespace tapfit::updating
