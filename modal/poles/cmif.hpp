// WeightedFrfs that show where the modes are, behind the stabilisation diagram.
#pragma once

#include "signal/frf_set/frf_set.hpp"

#include <Eigen/Core>

namespace tapfit::modal {

/// Root of the mean |H|^2 over all FRFs, per line [(m/s^2)/N].
[[nodiscard]] Eigen::VectorXd summed_frf(const signal::FrfSet& frfs);

/// Complex mode indicator function: singular values of the FRF matrix (outputs
/// x references that are complete) per line. A second large value at a peak is
/// a second mode at almost the same frequency.
///
/// Source: C. Shih et al., "Complex mode indication function", MSSP 2, 1988.
/// @return n_lines x min(outputs, references); empty without a complete matrix
/// @throws InputError as prepare_frfs does
[[nodiscard]] Eigen::MatrixXd cmif(const signal::FrfSet& frfs);

}  // namespace tapfit::modal
