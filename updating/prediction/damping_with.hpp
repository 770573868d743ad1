// Damping ratios of modes with the dampers that act on them, to first order:
//
//   zeta = zeta_own + sum_d b_d^2 Im z_d(j omega) / (2 omega^2),  b_d = phi'
//   e_d
//
// for modes of unit mass and dampers z of the effects and of the deck.
// Source: D. J. Ewins, "Modal Testing", 2nd ed., 2000, sec. 2.7 (light,
// non-proportional damping).
#pragma once

#include "updating/frf_model/frf_model.hpp"

#include <Eigen/Core>

#include <cstddef>
#include <vector>

namespace tapfit::updating {

/// What dampers of the state's effects and of the deck add to a mode's ratio.
/// @param phi of the mode, in the base's coordinates, of unit mass
/// @param omega of the mode, above zero [rad/s]
/// @param runs that were measured: what roves with a sensor counts as its mean
[[nodiscard]] double added_damping(const FrfModel& model,
                                   const ModelState& state,
                                   const Eigen::VectorXd& phi,
                                   double omega,
                                   const std::vector<std::size_t>& runs);

}  // namespace tapfit::updating
