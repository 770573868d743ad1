// Whether the FRF of a driving point is an accelerance, or rather a receptance
// that was declared one. Only one of them is a sum with positive terms:
//
//   accelerance   A(s) = sum_k c_k s^2 / ((s - p_k) (s - p_k*)) + 1/m + s^2 r
//   receptance    A(s) / s^2,   all of c_k, 1/m, r >= 0
//
// Both are tried with either sign by non-negative least squares. At the
// resonances a receptance looks like an accelerance that is turned over; below
// and between them it does not.
//
// Source: C. L. Lawson, R. J. Hanson, "Solving least squares problems", 1974,
// ch. 23.
#pragma once

#include "acquisition/bundle/test_bundle.hpp"
#include "acquisition/foundation/finding.hpp"
#include "modal/mode_set/mode_set.hpp"
#include "signal/frf_set/frf_set.hpp"

#include <Eigen/Core>

#include <vector>

namespace tapfit::modal {

/// x >= 0 that makes |A x - b| least; columns of A of any length.
///
/// @param A m x n, m >= n
/// @param b m
/// @return x, n
[[nodiscard]] Eigen::VectorXd nonnegative_fit(const Eigen::MatrixXd& A,
                                              const Eigen::VectorXd& b);

/// Channels that measure displacement where acceleration was declared, as their
/// driving points show.
[[nodiscard]] std::vector<Finding> motion_kind_findings(
    const acquisition::TestBundle& bundle,
    const signal::FrfSet& set,
    const ModeSet& modes);

}  // namespace tapfit::modal
