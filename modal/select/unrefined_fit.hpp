// What the poles of the stabilisation diagram alone would fit, to tell what
// refining them gained.
#pragma once

#include "modal/poles/stabilisation.hpp"
#include "modal/poles/weighted_frfs.hpp"

#include <Eigen/Core>

#include <vector>

namespace tapfit::modal {

/// The FRFs fitted by residues and residual terms to the diagram's own poles of
/// the modes given. A mode that only the refinement found has none there.
///
/// @param poles refined [rad/s], n_modes
/// @return accelerance, n_lines x n_frfs
[[nodiscard]] Eigen::MatrixXcd unrefined_fit(const WeightedFrfs& curves,
                                             const std::vector<Track>& tracks,
                                             const Eigen::VectorXcd& poles);

}  // namespace tapfit::modal
