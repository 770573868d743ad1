#include "updating/reduction/deck_through_base.hpp"

#include "updating/properties/uncertain_parts.hpp"
#include "updating/reduction/massless_dofs.hpp"
#include "updating/structure/assembly/assemble.hpp"
#include "updating/structure/solve/seen_through.hpp"

#include <Eigen/Eigenvalues>

namespace tapfit::updating {

using Eigen::MatrixXd;

ReducedBase deck_through_base(
    const structure::Deck& deck,
    const std::vector<acquisition::UncertainProperty>& uncertain,
    const BaseVectors& base) {
  const structure::System system = structure::assemble(deck);
  MatrixXd M = structure::seen_through(base.V, system.M);
  const auto lent = regularising_mass(system, base.points, base.high_hz);
  if (lent.size() > 0) M += structure::seen_through(base.V, lent);
  ReducedBase result;
  result.rows = base.rows;
  result.K = structure::seen_through(base.V, system.K);
  for (const UncertainPart& part : uncertain_parts(deck, uncertain)) {
    result.part_power.push_back(part.power);
    result.K_part.push_back(structure::seen_through(base.V, part.K));
    result.M_part.push_back(structure::seen_through(base.V, part.M));
  }
  const Eigen::GeneralizedSelfAdjointEigenSolver<MatrixXd> modes(result.K, M);
  result.turn(modes.eigenvectors());
  return result;
}

}  // namespace tapfit::updating
