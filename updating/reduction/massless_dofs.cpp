#include "updating/reduction/massless_dofs.hpp"

#include <cmath>
#include <numbers>

namespace tapfit::updating {

using structure::BorderedMatrix;
using structure::SparseMatrix;

SparseMatrix regularising_mass(const BorderedMatrix& stiffness,
                               const BorderedMatrix& mass,
                               const std::vector<int>& dofs,
                               double high_hz) {
  constexpr double above = 1e4;
  const double square = std::pow(2.0 * std::numbers::pi * above * high_hz, 2);
  std::vector<Eigen::Triplet<double>> lent;
  for (const int i : dofs) {
    const double K = stiffness.diagonal(i);
    if (mass.diagonal(i) != 0.0 || !(K > 0.0)) continue;
    lent.emplace_back(i, i, K / square);
  }
  if (lent.empty()) return {};
  SparseMatrix added(mass.rows(), mass.rows());
  added.setFromTriplets(lent.begin(), lent.end());
  return added;
}

SparseMatrix regularising_mass(const structure::System& system,
                               const std::vector<int>& points,
                               double high_hz) {
  std::vector<int> loose;
  for (const int i : points) {
    if (!system.inactive[static_cast<std::size_t>(i)]) loose.push_back(i);
  }
  return regularising_mass(system.K, system.M, loose, high_hz);
}

}  // namespace tapfit::updating
