// FRFs from identified modes.
//
//   H_ab(s) = s^2 sum_r [ R_r / (s - lambda_r) + conj(R_r) / (s -
//             conj(lambda_r)) ],  R_r = phi_a phi_b / (2 j omega_d,r)
//
// Modes outside the band are not in it; ModeSet::fitted has them.
#pragma once

#include "modal/mode_set/mode_set.hpp"
#include "signal/frf_set/frf_set.hpp"

#include <Eigen/Core>

#include <optional>

namespace tapfit::modal {

/// Accelerance between two points from the modes alone.
///
/// @param s lines [rad/s]
/// @return per line [(m/s^2)/N]; empty when the shapes are not scaled or do
///   not hold both points
[[nodiscard]] std::optional<Eigen::VectorXcd> synthesise(
    const ModeSet& modes,
    const Dof& response,
    const Dof& reference,
    const Eigen::VectorXcd& s);

/// The set with the fitted model in the place of what was measured: coherence 1
/// and no variance. FRFs the modes were not fitted to, and lines outside the
/// band of the fit, are left out.
///
/// @param frfs the set that the modes were identified from
/// @return no FRF when no mode was found
[[nodiscard]] signal::FrfSet fitted_set(const signal::FrfSet& frfs,
                                        const ModeSet& modes);

}  // namespace tapfit::modal
