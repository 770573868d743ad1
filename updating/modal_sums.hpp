// FRFs of a run on which nothing acts but what is in the modes: plain sums over
// them, on all lines at once. With modal rows r of the points and
// g_m = 1 / (s^2 + d_m s + lambda_m),
//
//   H_oi / s^2 = sum_m g_m r_mo r_mi,
//   d (H_oi / s^2) = sum_m g_m (t_mo r_mi + r_mo t_mi)
//                    - sum_m g_m^2 (d lambda_m + s d d_m) r_mo r_mi
//
// where the modes turn by A, t = A' r. Internal to frf_model.
#pragma once

#include "updating/run_lines.hpp"

#include <Eigen/Core>

namespace tapfit::updating {

/// Fills the response of the run's pairs, with derivatives where out.dH is
/// made: what RunLines::respond does line by line.
///
/// @param lines without actors
/// @param flexible modes x lines, see flexibility()
void sum_modes(const RunLines& lines,
               const Eigen::VectorXcd& s,
               const Eigen::MatrixXcd& flexible,
               ModelResponse& out);

}  // namespace tapfit::updating
