#include "updating/reduction/base_error.hpp"

#include "tests/updating/support/deck_support.hpp"
#include "updating/structure/assembly/assemble.hpp"
#include "updating/structure/solve/eigenmodes.hpp"

#include <Eigen/LU>

#include <numbers>

namespace tapfit::updating {
namespace {

using Eigen::Index;
using Eigen::MatrixXcd;
using Eigen::MatrixXd;

// Modes alone, without static responses: errors large enough to be compared
// with those of direct solves. What is left of omega / omega_r makes the
// estimate's own error.
TEST(BaseError, IsThatOfTheWholeModel) {
  structure::Plate plate;
  plate.a = 0.4;
  plate.b = 0.15;
  plate.thickness = 0.004;
  structure::Deck deck = structure::plate_deck(plate, 8, 3);
  for (int j = 1; j <= 4; ++j) deck.constraints.push_back({j, "123456"});
  const structure::System system = structure::assemble(deck);
  const structure::FreeMotions motions = structure::free_motions(system);
  constexpr double high_hz = 150.0;
  const double shift = std::pow(2.0 * std::numbers::pi * high_hz / 4.0, 2);
  const ResidualFlexibility answers(system, motions, shift);
  const std::vector<int> points = {6 * 35 + 2, 6 * 12 + 2};
  for (const Index count : {6, 12, 30}) {
    const structure::Eigenmodes modes = structure::eigenmodes(
        motions.reduce(system.K), motions.reduce(system.M), count);
    const MatrixXd V = motions.expand(modes.phi);
    const Eigen::VectorXd stiffness =
        (2.0 * std::numbers::pi * modes.frequency_hz).cwiseAbs2();
    double expected = 0.0;
    for (const double part : {0.3, 0.65, 1.0}) {
      const std::complex<double> s =
          2.0 * std::numbers::pi * part * high_hz * std::complex(0.03, 1.0);
      const MatrixXcd Z =
          MatrixXd(motions.reduce(system.K)).cast<std::complex<double>>() +
          s * s * MatrixXd(motions.reduce(system.M));
      MatrixXd forces = MatrixXd::Zero(system.dofs(), 2);
      forces(points[0], 0) = forces(points[1], 1) = 1.0;
      const MatrixXd felt = motions.project(forces);
      const MatrixXcd H =
          felt.transpose() *
          Z.partialPivLu().solve(felt.cast<std::complex<double>>());
      const MatrixXd rows = V(points, Eigen::all);
      const MatrixXcd reduced =
          rows * (stiffness.array() + s * s).inverse().matrix().asDiagonal() *
          rows.transpose();
      expected = std::max(expected, (H - reduced).norm() / H.norm());
    }
    const double found =
        base_error(system, answers, V, stiffness, points, high_hz);
    EXPECT_NEAR(found, expected, 0.1 * expected) << count << " modes";
    EXPECT_GT(expected, 1e-5);
  }
}

}  // namespace
}  // namespace tapfit::updating
