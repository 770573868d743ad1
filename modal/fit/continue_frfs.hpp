// FRFs known on one line of the s-plane, carried on to the right of it: what
// an exponential window on the recordings would have given.
//
// The modal model of each FRF (residues and residual terms for the identified
// poles) is evaluated at s. What the model leaves on the measured lines is
// analytic and bounded to the right of them, where Poisson's integral gives it,
//
//   r(sigma + j w) = (sigma / pi) int r(j v) / (sigma^2 + (w - v)^2) dv,
//
// v over the measured lines and their mirror images; outside r counts as 0.
#pragma once

#include "modal/mode_set/mode_set.hpp"
#include "signal/frf_set/frf_set.hpp"

#include <Eigen/Core>

namespace tapfit::modal {

/// @param frfs on evenly spaced lines of one sigma
/// @param modes identified from them
/// @param s lines within their band, Re(s) at least theirs [rad/s]
/// @return the FRFs on s in the same order. Variance is that of the measured
///   lines, or the square of what the model leaves where that is more, through
///   the same integral. Coherence is that of the nearest line.
/// @throws InputError as of prepare_frfs
[[nodiscard]] signal::FrfSet continue_frfs(const signal::FrfSet& frfs,
                                           const ModeSet& modes,
                                           const Eigen::VectorXcd& s);

}  // namespace tapfit::modal
