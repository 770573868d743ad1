#include "updating/prediction/form_shift.hpp"

#include <algorithm>
#include <cmath>

namespace tapfit::updating {

FormShift form_shift(const Eigen::VectorXd& omega,
                     const ModeAfter& after,
                     Eigen::Index mode) {
  const Eigen::VectorXd b = omega.cwiseProduct(after.u);
  const double w2 = after.omega * after.omega;
  // What the change itself adds in stiffness is known: below 1 without it.
  const double share = b.squaredNorm() / w2;
  if (share <= 1.0) return {1.0, share * share, b(mode) * b(mode) / w2};
  if (!(omega(mode) > 0.0)) return {1.0, 1.0, 0.0};
  const double c = after.omega * after.of_now / omega(mode);
  return {1.0, 1.0, std::min(1.0, c * c)};
}

}  // namespace tapfit::updating
