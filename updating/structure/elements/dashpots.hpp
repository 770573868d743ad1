// The dashpots of a deck (CDAMP, the B of a PBUSH) as rank-one terms of the
// damping matrix: C = sum of c b b'.
#pragma once

#include "updating/structure/deck/deck.hpp"

#include <Eigen/Core>

#include <functional>
#include <set>
#include <utility>
#include <vector>

namespace tapfit::structure {

struct Dashpot {
  double damping = 0.0;  ///< c [N s/m], [N m s/rad] for rotations
  /// b: degrees of freedom (6 grid_index + component - 1, basic axes) and their
  /// coefficients.
  std::vector<std::pair<int, double>> direction;
};

/// @throws InputError for one at a grid that does not exist
[[nodiscard]] std::vector<Dashpot> dashpots(const Deck& deck);

/// Degrees of freedom that they act on.
[[nodiscard]] std::set<int> damped_dofs(const Deck& deck);

/// F with V' C V = F F', as wide as the dashpots are independent in a base V,
/// however many there are.
/// @param size r, of the base
/// @param row of V for a degree of freedom, 6 grid_index + component - 1
/// @return r x rank
[[nodiscard]] Eigen::MatrixXd damping_factor(
    const Deck& deck,
    Eigen::Index size,
    const std::function<Eigen::RowVectorXd(int dof)>& row);

}  // namespace tapfit::structure
