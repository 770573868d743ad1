#include "updating/reduction/added_range.hpp"

#include "acquisition/foundation/constants.hpp"

#include <Eigen/Eigenvalues>

#include <algorithm>
#include <cmath>

namespace tapfit::updating {

using Eigen::Index;
using Eigen::MatrixXd;

ChangeRange added_range(const structure::SparseMatrix& S,
                        const MatrixXd& modes,
                        const Eigen::VectorXd& modes_hz,
                        double high_hz) {
  // Of what buckles the structure: its frequency is then a third.
  constexpr double nearly = 0.9;
  MatrixXd energy = modes.transpose() * (S * modes);
  double most = 0.0;
  for (Index r = 0; r < modes.cols(); ++r) {
    // What the whole does as a rigid body strains nothing.
    const bool strains = modes_hz(r) > 1e-3 * high_hz;
    const double unit = strains ? 1.0 / (two_pi * modes_hz(r)) : 0.0;
    energy.row(r) *= unit;
    energy.col(r) *= unit;
    if (modes_hz(r) > high_hz) continue;
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
