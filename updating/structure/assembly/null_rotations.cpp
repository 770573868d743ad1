#include "updating/structure/assembly/null_rotations.hpp"

#include "updating/structure/solve/eigenmodes.hpp"
#include "updating/structure/solve/factor.hpp"
#include "updating/structure/solve/free_motions.hpp"

#include <set>

namespace tapfit::structure {
namespace {

using Eigen::Index;
using Eigen::VectorXd;

// Places in `free` of the rotations of grids without shells.
std::vector<int> loose_rotations(const Deck& deck,
                                 const std::vector<int>& free) {
  std::set<int> plated;
  for (const Shell& e : deck.shells) {
    if (deck.shell_properties.at(e.property).panel) continue;
    const std::vector<int> grids = e.all_grids();
    plated.insert(grids.begin(), grids.end());
  }
  std::vector<int> places;
  for (std::size_t k = 0; k < free.size(); ++k) {
    const int grid = deck.grids[static_cast<std::size_t>(free[k] / 6)].id;
    if (free[k] % 6 < 3 || plated.contains(grid)) continue;
    places.push_back(static_cast<int>(k));
  }
  return places;
}

// Scaled to a unit diagonal, with a little of it added: what has neither
// stiffness nor inertia ends in a pivot of that size.
SparseMatrix scaled(const SparseMatrix& A, double added) {
  const VectorXd scale = A.diagonal().cwiseSqrt().cwiseInverse();
  SparseMatrix unit = scale.asDiagonal() * A * scale.asDiagonal();
  for (Index i = 0; i < unit.rows(); ++i) unit.coeffRef(i, i) += added;
  return unit;
}

}  // namespace

std::vector<int> null_rotations(const Deck& deck, const System& system) {
  // A line of n grids ends in a pivot of n times what is added.
  constexpr double added_share = 1e-13;
  constexpr double idle_share = 1e-10;
  const FreeMotions motions = free_motions(system);
  const std::vector<int> places = loose_rotations(deck, motions.free);
  if (places.empty()) return {};
  SparseMatrix A = extract(motions.reduce(system.K), places);
  const SparseMatrix M = extract(motions.reduce(system.M), places);
  if (!(A.diagonal().minCoeff() > 0.0)) return {};
  if (M.diagonal().sum() > 0.0) {
    A += A.diagonal().sum() / M.diagonal().sum() * M;
  }
  std::vector<int> idle;
  try {
    const VectorXd pivots = Factor(scaled(A, added_share)).pivots();
    for (Index k = 0; k < pivots.size(); ++k) {
      if (pivots(k) > idle_share) continue;
      const int place = places[static_cast<std::size_t>(k)];
      idle.push_back(motions.free[static_cast<std::size_t>(place)]);
    }
  } catch (const SingularMatrix&) {
    return {};  // the modes say where
  }
  return idle;
}

}  // namespace tapfit::structure
