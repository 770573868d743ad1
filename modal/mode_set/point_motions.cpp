#include "modal/mode_set/point_motions.hpp"

#include <algorithm>

namespace tapfit::modal {

std::map<int, Eigen::Vector3d> point_motions(const ModeSet& modes,
                                             const Eigen::VectorXd& shape) {
  std::map<int, Eigen::Vector3d> motions;
  const std::size_t count =
      std::min(modes.dofs.size(), static_cast<std::size_t>(shape.size()));
  for (std::size_t i = 0; i < count; ++i) {
    const Dof& dof = modes.dofs[i];
    if (dof.component < 1 || dof.component > 3) continue;
    auto [at, fresh] = motions.try_emplace(dof.node, Eigen::Vector3d::Zero());
    at->second[dof.component - 1] +=
        dof.sign * shape[static_cast<Eigen::Index>(i)];
  }
  return motions;
}

double factor_onto(const Eigen::VectorXd& other, const Eigen::VectorXd& shape) {
  const double size = shape.squaredNorm();
  if (other.size() != shape.size() || !(size > 0.0)) return 1.0;
  const double factor = other.dot(shape) / size;
  return factor == 0.0 ? 1.0 : factor;
}

}  // namespace tapfit::modal
