#include "updating/structure/solve/free_motions.hpp"

#include "updating/structure/solve/eigenmodes.hpp"

namespace tapfit::structure {

SparseMatrix FreeMotions::reduce(const SparseMatrix& A) const {
  if (T.size() == 0) return extract(A, free);
  const SparseMatrix AT = A * T;
  const SparseMatrix product = T.transpose() * AT;
  // Rounding of the products must not make the matrix unsymmetric.
  const SparseMatrix transposed = product.transpose();
  return 0.5 * (product + transposed);
}

Eigen::MatrixXd FreeMotions::expand(const Eigen::MatrixXd& q) const {
  if (T.size() > 0) return T * q;
  Eigen::MatrixXd u = Eigen::MatrixXd::Zero(dofs, q.cols());
  u(free, Eigen::all) = q;
  return u;
}

Eigen::MatrixXd FreeMotions::project(const Eigen::MatrixXd& forces) const {
  if (T.size() > 0) return T.transpose() * forces;
  return forces(free, Eigen::all);
}

FreeMotions free_motions(const System& system) {
  FreeMotions motions{system.free_dofs(), system.dofs(), {}};
  if (system.T.size() > 0) {
    motions.T = unit_motions(system.T, motions.free, motions.dofs);
  }
  return motions;
}

SparseMatrix unit_motions(const SparseMatrix& T,
                          const std::vector<int>& of,
                          Eigen::Index dofs) {
  std::vector<Eigen::Triplet<double>> entries;
  for (std::size_t k = 0; k < of.size(); ++k) {
    const auto column = static_cast<int>(k);
    if (of[k] >= T.cols()) {
      entries.emplace_back(of[k], column, 1.0);
      continue;
    }
    for (SparseMatrix::InnerIterator it(T, of[k]); it; ++it) {
      entries.emplace_back(static_cast<int>(it.row()), column, it.value());
    }
  }
  SparseMatrix units(dofs, static_cast<Eigen::Index>(of.size()));
  units.setFromTriplets(entries.begin(), entries.end());
  return units;
}

}  // namespace tapfit::structure
