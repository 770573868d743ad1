#include "updating/effects/suspension.hpp"

#include "acquisition/foundation/constants.hpp"

#include <cmath>
#include <limits>

namespace tapfit::effects {

double stiffest_spring(const Suspension& suspension,
                       const InterfaceDof& at,
                       const structure::Deck& deck) {
  Eigen::RowVectorXd b = Eigen::RowVectorXd::Zero(suspension.rigid.cols());
  const auto add = [&](int node, int component, double weight) {
    const auto grid = static_cast<Eigen::Index>(deck.grid_index(node));
    b += weight * suspension.rigid.row(6 * grid + component - 1);
  };
  if (at.between.empty()) add(at.node, at.component, 1.0);
  for (const updating::MotionShare& share : at.between) {
    add(share.node, share.component, share.weight);
  }
  constexpr double nothing = 1e-9;  // beside the largest motion: rounding
  if (b.size() == 0 ||
      b.norm() <= nothing * suspension.rigid.cwiseAbs().maxCoeff()) {
    return std::numeric_limits<double>::infinity();
  }
  return std::pow(two_pi * suspension.highest_hz, 2) / b.squaredNorm();
}

}  // namespace tapfit::effects
