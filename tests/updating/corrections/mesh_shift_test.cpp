#include "updating/corrections/mesh_shift.hpp"

#include "acquisition/foundation/constants.hpp"
#include "tests/updating/support/sample_plate.hpp"
#include "updating/structure/assembly/assemble.hpp"
#include "updating/structure/mesh/refine_mesh.hpp"
#include "updating/structure/solve/eigenmodes.hpp"
#include "updating/structure/solve/free_motions.hpp"

#include <Eigen/Eigenvalues>
#include <gtest/gtest.h>

#include <numbers>

namespace tapfit::updating {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

// Two grids, modes that move one of them each; the coarser mesh has them in the
// other order, at 0.9 of the frequency, and a third one it lacks.
TEST(MeshShiftTest, ComparesTheSameModes) {
  MeshModes finer{MatrixXd::Zero(12, 3), Eigen::Vector3d(10, 11, 30)};
  finer.rows(2, 0) = 2.0;
  finer.rows(8, 1) = -1.0;
  finer.rows(1, 2) = 1.0;
  MeshModes coarser{MatrixXd::Zero(12, 2), Eigen::Vector2d(9.9, 9)};
  coarser.rows(8, 0) = 1.0;
  coarser.rows(2, 1) = 2.0;
  const MeshShift shift = mesh_shift(finer, coarser);
  // Rounding of a difference of squares.
  EXPECT_NEAR(shift.K(0, 0), two_pi * two_pi * (100.0 - 81.0), 1e-9);
  EXPECT_NEAR(shift.K(1, 1), two_pi * two_pi * (121.0 - 98.01), 1e-9);
  EXPECT_EQ(shift.K(2, 2), 0.0);
  EXPECT_TRUE(shift.M.isZero(1e-12));
}

TEST(MeshShiftTest, AMeshWithoutModesMovesNone) {
  const MeshModes finer{MatrixXd::Ones(6, 1), VectorXd::Ones(1)};
  EXPECT_EQ(mesh_shift(finer, {MatrixXd(6, 0), {}}).K(0, 0), 0.0);
}

// Thirty modes that each take a little of one more would leave a mass that is
// not positive once the factor is far from 1: then only frequencies change.
TEST(MeshShiftTest, LeavesTheMassPositive) {
  constexpr Index n = 31;
  MeshModes finer{MatrixXd::Zero(6 * n, n), VectorXd::LinSpaced(n, 10, 40)};
  for (Index r = 0; r < n; ++r) finer.rows(6 * r + 2, r) = 1.0;
  MeshModes coarser = finer;
  coarser.hz *= 0.99;
  coarser.rows.row(6 * (n - 1) + 2).head(3).setConstant(-0.1);
  EXPECT_GT(mesh_shift(finer, coarser).M.norm(), 0.1);
  coarser.rows.row(6 * (n - 1) + 2).head(n - 1).setConstant(-0.1);
  const MeshShift shift = mesh_shift(finer, coarser);
  EXPECT_EQ(shift.M.norm(), 0.0);
  EXPECT_GT(shift.K(0, 0), 0.0);
  EXPECT_EQ(shift.K(0, n - 1), 0.0);
}

MeshModes modes_of(const structure::Deck& deck, Index grids) {
  const structure::System system = structure::assemble(deck);
  const structure::FreeMotions motions = structure::free_motions(system);
  const structure::Eigenmodes found = structure::eigenmodes(
      motions.reduce(system.K), motions.reduce(system.M), 24);
  return {motions.expand(found.phi).topRows(6 * grids), found.frequency_hz};
}

// Taking the change off the finer mesh's modal matrices leaves the coarser
// mesh's modes: frequencies, and how far a corner moves.
TEST(MeshShiftTest, LeadsBackToTheCoarserMesh) {
  const structure::Deck deck = support::plate_deck(true);
  const auto grids = static_cast<Index>(deck.grids.size());
  const MeshModes coarser = modes_of(deck, grids);
  const MeshModes finer = modes_of(structure::refine_mesh(deck).deck, grids);
  const MeshShift shift = mesh_shift(finer, coarser);
  const VectorXd l = (two_pi * finer.hz).cwiseAbs2();
  const Eigen::GeneralizedSelfAdjointEigenSolver<MatrixXd> back(
      MatrixXd(l.asDiagonal()) - shift.K,
      MatrixXd::Identity(l.size(), l.size()) - shift.M);
  const MatrixXd rows = finer.rows * back.eigenvectors();
  const Index corner = 6 * 10 + 2;  // grid 11, z
  for (Index r = 0; r < 6; ++r) {
    const double fine = std::abs(finer.rows(corner, r));
    const double coarse = std::abs(coarser.rows(corner, r));
    const double found = std::abs(rows(corner, r));
    // First order: what is left is of the change's own size squared, and what
    // the 24 modes do not span.
    EXPECT_NEAR(
        std::sqrt(back.eigenvalues()(r)) / two_pi,
        coarser.hz(r),
        0.1 * std::abs(finer.hz(r) - coarser.hz(r)) + 1e-3 * finer.hz(r))
        << r;
    EXPECT_NEAR(found, coarse, 0.25 * std::abs(fine - coarse) + 1e-3 * fine)
        << r;
  }
}

}  // namespace
}  // namespace tapfit::updating
