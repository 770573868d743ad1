// The natural frequencies that a structure would have without some masses, from
// its identified modes alone.
//
// In the coordinates of the identified modes (unit modal mass, as loaded) the
// stiffness is diag(w_r^2) and the mass without the masses m_q
//
//   M = I - sum_q m_q G_q,   G_q = sum over q's directions of phi phi'
//
// so the frequencies without them are those of diag(w^2) v = w0^2 M v, and
// d ln w0 / d m_q = v' G_q v / (2 v' M v); for a small mass
// ln(w0 / w) = m phi^2 / 2. Modes that were not identified are left out, which
// costs a relative error of the order (m phi^2)^2.
#pragma once

#include <Eigen/Core>

#include <optional>
#include <vector>

namespace tapfit::modal {

struct UnloadedModes {
  Eigen::VectorXd log_omega;   ///< ln w0, n_modes, in the order given
  Eigen::MatrixXd derivative;  ///< to each mass, n_modes x n_masses [1/kg]
  /// A shape without the masses is one with them times this, n_modes square.
  Eigen::MatrixXd vectors;
};

/// @param log_omega ln of the loaded structure's frequencies, n_modes
/// @param phi per mass its directions x n_modes [1/sqrt(kg)]
/// @param kg per mass
/// @return empty when the masses are more than the modes hold (M not positive
///   definite)
[[nodiscard]] std::optional<UnloadedModes> unload(
    const Eigen::VectorXd& log_omega,
    const std::vector<Eigen::MatrixXd>& phi,
    const Eigen::VectorXd& kg);

}  // namespace tapfit::modal
