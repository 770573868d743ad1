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
  return free_motions(system.T, system.free_dofs(), system.dofs());
}

FreeMotions free_motions(const SparseMatrix& T,
                         std::vector<int> free,
                         Eigen::Index dofs) {
  FreeMotions motions{std::move(free), dofs, {}};
  if (T.size() == 0) return motions;
  std::vector<Eigen::Triplet<double>> entries;
  for (std::size_t k = 0; k < motions.free.size(); ++k) {
    for (SparseMatrix::InnerIterator it(T, motions.free[k]); it; ++it) {
      entries.emplace_back(
          static_cast<int>(it.row()), static_cast<int>(k), it.value());
    }
  }
  motions.T.resize(dofs, motions.size());
  motions.T.setFromTriplets(entries.begin(), entries.end());
  return motions;
}

}  // namespace tapfit::structure
