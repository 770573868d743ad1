// One mode or two? Poles within a bandwidth of each other.
//
// A polynomial of too high an order splits a mode in two. The residues of two
// poles that close are badly known, but their sum is not: R_q + R_r, outputs x
// references, is of rank one for a single mode and of rank two for two. A mode
// whose frequency moved from hit to hit is split too, into shapes whose points
// do not move in phase.
#pragma once

#include "modal/fit/modal_fit.hpp"
#include "modal/poles/frf_matrix.hpp"

namespace tapfit::modal {

/// Whether pole r is the weaker of two within a bandwidth whose residues have
/// one shape or are out of phase, and with several references a sum of rank
/// one.
[[nodiscard]] bool is_split(const FrfMatrix& matrix,
                            const ModalFit& fit,
                            Eigen::Index r);

}  // namespace tapfit::modal
