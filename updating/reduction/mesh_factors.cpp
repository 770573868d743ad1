#include "updating/reduction/mesh_factors.hpp"

#include "updating/structure/mesh/edge_twist.hpp"

namespace tapfit::updating {

using Eigen::MatrixXd;

std::vector<MeshFactor> mesh_factors(const structure::Deck& deck,
                                     const MatrixXd& V,
                                     const MeshModes& finer,
                                     const MeshModes& coarser) {
  const MeshShift shift = mesh_shift(finer, coarser);
  const auto in_base = [&V](const MatrixXd& of_modes) {
    MatrixXd whole = MatrixXd::Zero(V.cols(), V.cols());
    whole.topLeftCorner(of_modes.rows(), of_modes.cols()) = of_modes;
    return whole;
  };
  std::vector<MeshFactor> factors;
  factors.push_back({in_base(shift.K), in_base(shift.M), {}});
  const structure::SparseMatrix edges = -structure::edge_twist(deck);
  MatrixXd K = V.transpose() * (edges * V);
  if (K.isZero(0.0)) return factors;
  factors.push_back({std::move(K), in_base({}), edges});
  return factors;
}

std::string mesh_factor_name(std::size_t factor) {
  return factor == 0 ? "mesh size" : "mesh edges";
}

std::vector<double> mesh_factor_sd(std::size_t factors) {
  // The limit of fine meshes is at 4/3 where convergence is quadratic, at 2
  // where it is linear. Of the edges' layer anything between nothing and all
  // may be missing, or too much: evenly spread, sd 0.29.
  const std::vector<double> sd = {0.5, 0.3};
  return {sd.begin(), sd.begin() + static_cast<std::ptrdiff_t>(factors)};
}

}  // namespace tapfit::updating
