#include "updating/prediction/form_shift.hpp"

namespace tapfit::updating {

FormShift form_shift(const Eigen::VectorXd& omega,
                     Eigen::Index mode,
                     const Eigen::VectorXd& u,
                     double omega_after) {
  const Eigen::VectorXd b = omega.cwiseProduct(u);
  const double w2 = omega_after * omega_after;
  // What the change itself adds in stiffness is known: below 1 without it.
  const double share = b.squaredNorm() / w2;
  return {1.0, share * share, b(mode) * b(mode) / w2};
}

}  // namespace tapfit::updating
