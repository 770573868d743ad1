#include "updating/structure/elements/section_matrices.hpp"

#include <Eigen/Dense>

namespace tapfit::structure {

Eigen::Matrix3d ShellSection::least_bending() const {
  if (!is_coupled()) return bending;
  const Eigen::Matrix3d least =
      bending - coupling * membrane.ldlt().solve(coupling);
  return 0.5 * (least + least.transpose());
}

}  // namespace tapfit::structure
