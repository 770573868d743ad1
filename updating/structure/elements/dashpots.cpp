#include "updating/structure/elements/dashpots.hpp"

#include "updating/structure/elements/element_matrices.hpp"

#include <Eigen/Eigenvalues>

namespace tapfit::structure {
namespace {

// b over the grids that are not ground (0), six each.
Dashpot dashpot(const Deck& deck,
                const std::array<int, 2>& grids,
                double damping,
                const Eigen::VectorXd& b) {
  Dashpot result{damping, {}};
  Eigen::Index from = 0;
  for (const int grid : grids) {
    if (grid == 0) continue;
    const int first = 6 * static_cast<int>(deck.grid_index(grid));
    for (int c = 0; c < 6; ++c) {
      const double part = b(from + c);
      if (part != 0.0) result.direction.emplace_back(first + c, part);
    }
    from += 6;
  }
  return result;
}

}  // namespace

std::vector<Dashpot> dashpots(const Deck& deck) {
  std::vector<Dashpot> result;
  for (const ScalarElement& e : deck.scalars) {
    if (e.damping == 0.0) continue;
    result.push_back(dashpot(deck, e.grids, e.damping, scalar_direction(e)));
  }
  for (const Bush& e : deck.bushes) {
    for (std::size_t c = 0; c < 6; ++c) {
      if (e.damping[c] == 0.0) continue;
      const Eigen::VectorXd b =
          bush_strains(e).row(static_cast<Eigen::Index>(c));
      result.push_back(dashpot(deck, e.grids, e.damping[c], b));
    }
  }
  return result;
}

std::set<int> damped_dofs(const Deck& deck) {
  std::set<int> dofs;
  for (const Dashpot& dashpot : dashpots(deck)) {
    for (const auto& [dof, part] : dashpot.direction) {
      dofs.insert(dof);
    }
  }
  return dofs;
}

Eigen::MatrixXd damping_factor(
    const Deck& deck,
    Eigen::Index size,
    const std::function<Eigen::RowVectorXd(int dof)>& row) {
  Eigen::MatrixXd C = Eigen::MatrixXd::Zero(size, size);
  for (const Dashpot& dashpot : dashpots(deck)) {
    Eigen::VectorXd b = Eigen::VectorXd::Zero(size);
    for (const auto& [dof, part] : dashpot.direction) {
      b += part * row(dof).transpose();
    }
    C += dashpot.damping * b * b.transpose();
  }
  if (C.isZero(0.0)) return Eigen::MatrixXd(size, 0);
  const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> solver(C);
  const Eigen::VectorXd& c = solver.eigenvalues();
  const Eigen::Index rank = (c.array() > 1e-13 * c(c.size() - 1)).count();
  return solver.eigenvectors().rightCols(rank) *
         c.tail(rank).cwiseSqrt().asDiagonal();
}

}  // namespace tapfit::structure
