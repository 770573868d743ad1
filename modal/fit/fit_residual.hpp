// What a fit makes of the FRFs, and what it leaves of them, a few lines at a
// time.
#pragma once

#include "modal/fit/modal_model.hpp"
#include "modal/poles/weighted_frfs.hpp"

#include <Eigen/Core>

#include <utility>
#include <vector>

namespace tapfit::modal {

/// The fitted accelerances, n_lines x n_frfs.
[[nodiscard]] Eigen::MatrixXcd fitted_accelerance(const WeightedFrfs& curves,
                                                  const ModalFit& fit);

/// On some lines only: count x n_frfs.
[[nodiscard]] Eigen::MatrixXcd fitted_accelerance(const WeightedFrfs& curves,
                                                  const ModalFit& fit,
                                                  Eigen::Index begin,
                                                  Eigen::Index count);

/// Lines from the first to before the second.
using LineRange = std::pair<Eigen::Index, Eigen::Index>;

/// Weighted squares that are left on each line, over all FRFs: n_lines.
///
/// @param wanted other lines may be left out, and are 0 then
[[nodiscard]] Eigen::VectorXd left_per_line(
    const WeightedFrfs& curves,
    const ModalFit& fit,
    const std::vector<LineRange>& wanted);

}  // namespace tapfit::modal
