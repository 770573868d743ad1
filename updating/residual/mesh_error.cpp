#include "updating/residual/mesh_error.hpp"

#include <Eigen/QR>

namespace tapfit::updating {

double mesh_error(const FrfModel& finer,
                  const FrfModel& coarser,
                  const ModelState& state,
                  const Target& target) {
  const ModelResponse fine = finer.respond(state, target.s, false);
  // The coarser model's derivatives: it knows nothing of a factor for the
  // mesh, which would take the whole difference up.
  const ModelResponse coarse = coarser.respond(state, target.s, true);
  Eigen::VectorXd d = stack(target, fine.H - coarse.H);
  Eigen::MatrixXd J(d.size(), static_cast<Eigen::Index>(coarse.dH.size()));
  for (std::size_t k = 0; k < coarse.dH.size(); ++k) {
    J.col(static_cast<Eigen::Index>(k)) = stack(target, coarse.dH[k]);
  }
  // Modes tell nothing of damping: columns may be zero, and all of them.
  if (J.cols() > 0) d -= J * J.completeOrthogonalDecomposition().solve(d);
  constexpr double left_over = 0.5;
  return left_over * d.norm();
}

}  // namespace tapfit::updating
