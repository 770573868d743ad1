// FRFs of a run as sums over its modes, on all lines at once. With modal rows r
// of the points and of what the effects act on, and
// g_m = 1 / (s^2 + d_m s + lambda_m),
//
//   S_qp = sum_m g_m r_mq r_mp,   u_p = D (I + S_BB D)^-1 S_Bp,
//   H_oi / s^2 = S_oi - u_o' S_Bi,
//
// the update of eq. 15 with sums over the modes in the place of the base's
// receptance. Where the modes turn by A, rows by t = A' r,
//
//   dS_qp = sum_m g_m (t_mq r_mp + r_mq t_mp)
//           - sum_m g_m^2 (d lambda_m + s d d_m) r_mq r_mp,
//   d (H_oi / s^2) = dS_oi - u_o' dS_Bi - dS_oB u_i + u_o' dS_BB u_i.
//
// Internal to frf_model.
#pragma once

#include "updating/frf_model/run_response.hpp"

#include <Eigen/Core>

namespace tapfit::updating {

/// Fills the response of the run's pairs, with derivatives where out.dH is
/// made.
///
/// @param flexible modes x lines, see flexibility()
void superpose_modes(const RunResponse& lines,
                     const Eigen::VectorXcd& s,
                     const Eigen::MatrixXcd& flexible,
                     ModelResponse& out);

}  // namespace tapfit::updating
