// Offsets, pins, springs and concentrated masses against closed forms.
#include "acquisition/foundation/constants.hpp"
#include "tests/updating/support/deck_support.hpp"
#include "updating/structure/assembly/assemble.hpp"
#include "updating/structure/solve/factor.hpp"

#include <Eigen/Dense>

#include <cmath>

namespace tapfit::structure {
namespace {

// E = 2e11, G = 8e10, A = 1e-4, I1 = 3e-9, I2 = 1e-9, J = 2e-9; 1 m along x;
// plane 1 holds z.
const std::string beam = R"(GRID,1,,0.,0.,0.
GRID,2,,1.,0.,0.
MAT1,1,2.+11,8.+10,,0.
PBAR,1,1,1.-4,3.-9,1.-9,2.-9
SPC1,1,123456,1
)";

// Displacements of grid 2 under forces and moments there.
Eigen::VectorXd tip_answer(const Deck& deck,
                           const Eigen::Matrix<double, 6, 1>& force) {
  const System system = assemble(deck);
  const Eigen::MatrixXd K = system.K;
  return K.block<6, 6>(6, 6).ldlt().solve(force);
}

Eigen::Matrix<double, 6, 1> unit(Eigen::Index component) {
  return Eigen::Matrix<double, 6, 1>::Unit(component);
}

TEST(Connections, OffsetBarIsPulledAndBent) {
  // The axis runs 0.1 m above the grids: a pull at the grid also bends it.
  const Deck deck =
      deck_of(beam + "CBAR,1,1,1,2,0.,0.,1.\n,,,0.,0.,.1,0.,0.,.1\n");
  const Eigen::VectorXd u = tip_answer(deck, unit(0));
  const double EA = 2e11 * 1e-4;
  const double EI = 2e11 * 3e-9;
  EXPECT_NEAR(u(0) / (1 / EA + 0.01 / EI), 1.0, 1e-9);
  EXPECT_NEAR(std::abs(u(4)) / (0.1 / EI), 1.0, 1e-9);
  EXPECT_NEAR(std::abs(u(2)) / (0.05 / EI), 1.0, 1e-9);
}

TEST(Connections, PinsReleaseWhatTheyName) {
  const auto stiffness = [](const std::string& pins, Eigen::Index component) {
    const Deck deck = deck_of(beam + "CBAR,1,1,1,2,0.,0.,1.\n," + pins + "\n");
    return Eigen::MatrixXd(assemble(deck).K)(6 + component, 6 + component);
  };
  const double EI1 = 2e11 * 3e-9;
  const double EI2 = 2e11 * 1e-9;
  EXPECT_NEAR(stiffness("", 2), 12 * EI1, 1e-9 * EI1);
  // Component 6 turns in plane 1, along z; 5 in plane 2, along y.
  EXPECT_NEAR(stiffness("6,", 2), 3 * EI1, 1e-9 * EI1);  // PA
  EXPECT_NEAR(stiffness(",6", 2), 3 * EI1, 1e-9 * EI1);  // PB
  EXPECT_NEAR(stiffness("6,", 1), 12 * EI2, 1e-9 * EI2);
  EXPECT_NEAR(stiffness("5,", 1), 3 * EI2, 1e-9 * EI2);
  EXPECT_NEAR(stiffness("6,6", 2), 0.0, 1e-9 * EI1);
  EXPECT_NEAR(stiffness("1,", 0), 0.0, 1e-9 * EI1);
  EXPECT_NEAR(stiffness("4,", 3), 0.0, 1e-9 * EI1);
  EXPECT_NEAR(stiffness("4,", 0), 2e11 * 1e-4, 1.0);
}

TEST(Connections, MassSwingsWithItsOffsetAndInertia) {
  // Torsion: G J / (I11 + m y^2); the beam has no mass, all else is held.
  const Deck deck = deck_of(beam +
                            "CBAR,1,1,1,2,0.,0.,1.\n"
                            "CONM2,2,2,,3.,0.,.2,0.\n,.05\nSPC1,1,12356,2\n");
  const Eigen::VectorXd f = modes_of(deck, 2).frequency_hz;
  ASSERT_EQ(f.size(), 1);
  EXPECT_NEAR(f(0), std::sqrt(8e10 * 2e-9 / (0.05 + 3 * 0.04)) / two_pi, 1e-9);
}

TEST(Connections, MassIsTurnedByItsCoordinateSystem) {
  // System 1 has its x along basic y: I11 there is I22 in basic axes.
  const Deck deck = deck_of(beam +
                            "CORD2R,1,,0.,0.,0.,0.,0.,1.\n,0.,1.,0.\n"
                            "CONM2,2,2,1,3.,.2,0.,0.\n,.05\n");
  EXPECT_TRUE(
      deck.masses[0].offset.isApprox(Eigen::Vector3d(0, 0.2, 0), 1e-12));
  EXPECT_NEAR(deck.masses[0].inertia(1, 1), 0.05, 1e-15);
  EXPECT_NEAR(deck.masses[0].inertia(0, 0), 0.0, 1e-15);
}

TEST(Connections, SpringFollowsTheDisplacementAxes) {
  // CD 1 has its x at 30 degrees to basic x.
  const Deck deck = deck_of(
      "CORD2R,1,,0.,0.,0.,0.,0.,1.\n,.8660254,.5,0.\n"
      "GRID,1,,0.,0.,0.,1\nCELAS2,1,400.,1,1\nCELAS2,2,100.,1,2\n"
      "CONM2,3,1,,1.\n");
  const Eigen::MatrixXd K = assemble(deck).K;
  // R diag(400, 100) R'.
  EXPECT_NEAR(K(0, 0), 400 * 0.75 + 100 * 0.25, 1e-4);
  EXPECT_NEAR(K(0, 1), 300 * std::sqrt(3.0) / 4, 1e-4);
  EXPECT_NEAR(K(1, 1), 400 * 0.25 + 100 * 0.75, 1e-4);
  const Eigen::VectorXd f = modes_of(deck, 3).frequency_hz;
  ASSERT_EQ(f.size(), 2);
  EXPECT_NEAR(f(0), 10 / two_pi, 1e-6);
  EXPECT_NEAR(f(1), 20 / two_pi, 1e-6);
}

TEST(Connections, SpringAndDamperBetweenTwoGrids) {
  const Deck deck = deck_of(
      "GRID,1,,0.,0.,0.\nGRID,2,,1.,0.,0.\nPELAS,7,250.\nCELAS1,1,7,1,1,2,1\n"
      "CDAMP2,2,5.,1,1,2,1\nCONM2,3,1,,2.\nCONM2,4,2,,2.\n");
  EXPECT_EQ(deck.scalars[1].damping, 5.0);
  const Eigen::VectorXd f = modes_of(deck, 2).frequency_hz;
  ASSERT_EQ(f.size(), 2);
  // Free: one rigid motion, then k (1/m + 1/m).
  EXPECT_LT(f(0), 1e-3);
  EXPECT_NEAR(f(1), std::sqrt(250.0) / two_pi, 1e-9);
}

}  // namespace
}  // namespace tapfit::structure
