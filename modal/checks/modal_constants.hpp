// The room modal/checks. Whether FRFs agree on one structure: every run with
// the others, every channel with what an accelerometer can measure.
// In:  FRFs and identified modes.
// Out: Findings. Nothing is changed.
// May include: its row in CONTRIBUTING.md.
//
// Modal constants of every FRF by itself, for poles that are the same in all:
//
//   H(s) = sum_k s^2 (a_k / (s - p_k) + conj) + r0 + r2 s^2 + r4 s^4
//   z_k = 2 j w_dk a_k
//
// z = phi_o phi_i is real for a normal mode of an accelerance. With a second
// column pair a'_k / (s - p_k)^2 the FRF also says how far its own pole lies
// from p_k, to the first order: dp = a' / a.
//
// Source: D. J. Ewins, "Modal testing", 2nd ed. 2000, 2.4 and 4.3.
#pragma once

#include "signal/frf_set/frf_set.hpp"

#include <Eigen/Core>

#include <vector>

namespace tapfit::modal {

/// What one FRF says of each mode.
struct ModalConstants {
  Eigen::VectorXcd z;    ///< per pole [1/kg]
  Eigen::VectorXd sd;    ///< of either part of z
  Eigen::VectorXd peak;  ///< |z| / (2 damping ratio): height of the peak
  /// Change of frequency against the pole's, relative, and its sd; empty unless
  /// asked for.
  Eigen::VectorXd shift;
  Eigen::VectorXd shift_sd;
  /// Rms of what the fit leaves over rms of H, noise taken off.
  double left = 0.0;
};

/// Poles of 1 % damping just outside the lines, 2, 7, 20 and 60 % beside them
/// (below: 2 and 10 %). With the residual terms their combinations stand for
/// any mode out there: what they leave of one is below a per cent.
[[nodiscard]] Eigen::VectorXcd poles_beside(const Eigen::VectorXcd& s);

/// Weighted by the FRF's own variance and by 1 % of it line by line, so that
/// no line counts for more than its scale is known.
///
/// @param poles [rad/s], Im > 0
/// @param shifts whether each FRF may have poles of its own
/// @return as `set.frfs`
[[nodiscard]] std::vector<ModalConstants> modal_constants(
    const signal::FrfSet& set, const Eigen::VectorXcd& poles, bool shifts);

}  // namespace tapfit::modal
