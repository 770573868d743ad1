#include "updating/reduction/change_range.hpp"

#include "acquisition/foundation/constants.hpp"
#include "updating/structure/solve/free_motions.hpp"
#include "updating/structure/solve/seen_through.hpp"

#include <Eigen/Eigenvalues>

#include <algorithm>
#include <cmath>
#include <vector>

namespace tapfit::updating {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

ChangeRange spring_range(const ReleasedSystem& released,
                         const ScaledStiffness& own,
                         const PlainModes& modes,
                         const structure::SparseMatrix& T) {
  std::vector<int> held;
  std::vector<double> length;
  for (int k = 0; k < static_cast<int>(own.S.cols()); ++k) {
    if (!(own.S.coeff(k, k) > 0.0)) continue;
    held.push_back(k);
    double whole = 0.0;
    for (const ScaledStiffness& part : released.scaled) {
      if (part.change == own.change) whole += part.S.coeff(k, k);
    }
    length.push_back(whole);
  }
  // What holds them feels of the rigid structure's modes, with what follows a
  // rigid element: the forces of unit motions, on few degrees of freedom, say.
  const structure::SparseMatrix forces =
      released.K.times(structure::unit_motions(T, held, released.dofs()));
  const structure::SparseMatrix response =
      forces.topRows(modes.shapes.rows()).transpose();
  double worst = 0.0;
  for (Index r = 0; r < modes.hz.size(); ++r) {
    if (modes.hz(r) > modes.high_hz || modes.hz(r) < 1e-3) continue;
    const VectorXd reaction = response * modes.shapes.col(r);
    double sum = 0.0;
    for (std::size_t k = 0; k < held.size(); ++k) {
      sum += std::pow(reaction(static_cast<Index>(k)), 2) / length[k];
    }
    worst = std::max(worst, sum / std::pow(two_pi * modes.hz(r), 2));
  }
  if (worst <= 0.0) worst = 1.0;
  const double upper = worst / 1e-4;
  // A hundredth of where the first order would leave no stiffness: a hinge.
  return {0.0, upper, worst / 100.0, worst / 0.1, upper};
}

ChangeRange added_range(const structure::SparseMatrix& S,
                        const PlainModes& modes) {
  // Of what buckles the structure: its frequency is then a third.
  constexpr double nearly = 0.9;
  MatrixXd energy = structure::seen_through(modes.shapes, S);
  double most = 0.0;
  for (Index r = 0; r < modes.hz.size(); ++r) {
    // What the whole does as a rigid body strains nothing.
    const bool strains = modes.hz(r) > 1e-3 * modes.high_hz;
    const double unit = strains ? 1.0 / (two_pi * modes.hz(r)) : 0.0;
    energy.row(r) *= unit;
    energy.col(r) *= unit;
    if (modes.hz(r) > modes.high_hz) continue;
    most = std::max(most, std::abs(energy(r, r)));
  }
  if (most <= 0.0) most = 1.0;
  ChangeRange range = {0.0, 0.0, 1e-4 / most, 0.1 / most, 10.0 / most};
  if (energy.trace() >= 0.0) return range;
  const double lowest =
      Eigen::SelfAdjointEigenSolver<MatrixXd>(energy, Eigen::EigenvaluesOnly)
          .eigenvalues()(0);
  range.upper = nearly / -lowest;
  range.start = std::min(range.start, 0.5 * range.upper);
  range.lower = std::min(range.lower, 1e-3 * range.upper);
  return range;
}

ChangeRange range_of(const ReleasedSystem& released,
                     const ScaledStiffness& own,
                     ChangeKind kind,
                     const PlainModes& modes,
                     const structure::System& system) {
  if (kind == ChangeKind::Elements) return loss_range;
  if (kind != ChangeKind::Preload) {
    return spring_range(released, own, modes, system.T);
  }
  const Index n = system.dofs();
  return added_range(own.S.topLeftCorner(n, n), modes);
}

}  // namespace tapfit::updating
