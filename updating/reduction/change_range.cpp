#include "updating/reduction/change_range.hpp"

#include "acquisition/foundation/constants.hpp"

#include <Eigen/Eigenvalues>

#include <algorithm>
#include <cmath>

namespace tapfit::updating {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

ChangeRange spring_range(const ReleasedSystem& released,
                         const ScaledStiffness& own,
                         const PlainModes& modes,
                         const structure::SparseMatrix& T) {
  VectorXd length = VectorXd::Zero(released.dofs());
  for (const ScaledStiffness& part : released.scaled) {
    if (part.change == own.change) length += part.S.diagonal();
  }
  MatrixXd rigid = MatrixXd::Zero(released.dofs(), modes.hz.size());
  rigid.topRows(modes.shapes.rows()) = modes.shapes;
  MatrixXd reaction = released.K * rigid;
  if (T.size() > 0) {
    // Of what follows a rigid element too.
    reaction.topRows(T.rows()) =
        (T.transpose() * reaction.topRows(T.rows())).eval();
  }
  const VectorXd held = own.S.diagonal();
  double worst = 0.0;
  for (Index r = 0; r < modes.hz.size(); ++r) {
    if (modes.hz(r) > modes.high_hz || modes.hz(r) < 1e-3) continue;
    double sum = 0.0;
    for (Index k = 0; k < held.size(); ++k) {
      if (held(k) > 0.0) sum += std::pow(reaction(k, r), 2) / length(k);
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
  MatrixXd energy = modes.shapes.transpose() * (S * modes.shapes);
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

}  // namespace tapfit::updating
