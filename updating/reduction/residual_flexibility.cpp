#include "updating/reduction/residual_flexibility.hpp"

#include "updating/reduction/subspace.hpp"
#include "updating/structure/solve/symmetric_product.hpp"

#include <algorithm>
#include <utility>

namespace tapfit::updating {

using Eigen::Index;
using Eigen::MatrixXd;

const structure::Factor& ResidualFlexibility::factor() const {
  std::call_once(once_, [this] {
    const structure::SparseMatrix A =
        motions_.reduce(system_.K) + shift_ * motions_.reduce(system_.M);
    factor_ = std::make_unique<structure::Factor>(A);
  });
  return *factor_;
}

MatrixXd ResidualFlexibility::to(const MatrixXd& forces) const {
  // What a solution needs besides is as long as the model, several times.
  constexpr Index width = 16;
  MatrixXd answers(system_.dofs(), forces.cols());
  for (Index first = 0; first < forces.cols(); first += width) {
    const Index count = std::min(width, forces.cols() - first);
    answers.middleCols(first, count) = motions_.expand(
        factor().solve(motions_.project(forces.middleCols(first, count))));
  }
  return answers;
}

MatrixXd ResidualFlexibility::to_points(const std::vector<int>& points,
                                        std::size_t orders) const {
  MatrixXd forces =
      MatrixXd::Zero(system_.dofs(), static_cast<Index>(points.size()));
  for (std::size_t k = 0; k < points.size(); ++k) {
    forces(points[k], static_cast<Index>(k)) = 1.0;
  }
  const MatrixXd felt = motions_.project(forces);
  std::vector<Index> moving;
  for (Index k = 0; k < felt.cols(); ++k) {
    if (!felt.col(k).isZero(0.0)) moving.push_back(k);
  }
  std::vector<MatrixXd> all = {to(MatrixXd(forces(Eigen::all, moving)))};
  while (all.size() < orders) {
    all.push_back(to(structure::symmetric_product(system_.M, all.back())));
  }
  return join(std::move(all));
}

}  // namespace tapfit::updating
