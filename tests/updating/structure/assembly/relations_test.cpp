// MPC, RBE3, RBE1, RROD, RBAR with shared ends, scalar points and DMIG, against
// closed forms and the definition.
#include "acquisition/foundation/input_error.hpp"
#include "tests/support/matchers.hpp"
#include "tests/updating/support/deck_support.hpp"
#include "updating/structure/readers/scale_units.hpp"

#include <Eigen/Dense>

#include <cmath>

namespace tapfit::structure {
namespace {

using Eigen::MatrixXd;
using Eigen::Vector3d;
using Eigen::VectorXd;

const std::string corners =
    "GRID,1,,0.,0.,0.\nGRID,2,,2.,0.,0.\nGRID,3,,2.,1.,0.3\nGRID,4,,0.,1.,0.\n"
    "GRID,9,,.7,.2,.5\n";

// A rigid motion of the averaged grids is one of the reference grid.
void expect_rigid(const Deck& deck) {
  const System system = assemble(deck);
  VectorXd q = VectorXd::Zero(system.dofs());
  const Vector3d t(0.1, -0.2, 0.3);
  const Vector3d w(0.4, 0.5, -0.6);
  VectorXd expected = q;
  for (std::size_t k = 0; k < deck.grids.size(); ++k) {
    const auto at = 6 * static_cast<Eigen::Index>(k);
    expected.segment<3>(at) = t + w.cross(deck.grids[k].position);
    expected.segment<3>(at + 3) = w;
  }
  // Entries that follow have empty columns.
  const VectorXd u = system.T * expected;
  EXPECT_LT((u - expected).norm(), 1e-12 * expected.norm());
}

TEST(Relations, Rbe3CarriesRigidMotion) {
  expect_rigid(deck_of(corners + "RBE3,7,,9,123456,1.,123,1,2,\n,3,4\n"));
  expect_rigid(
      deck_of(corners + "RBE3,7,,9,123456,1.,123,1,2,\n,3,2.5,123,4\n"));
  expect_rigid(deck_of(corners + "RBE3,7,,9,123456,1.,123456,1,3\n"));
  // Others follow instead of the reference.
  expect_rigid(deck_of(corners +
                       "RBE3,7,,9,123456,1.,123,1,2,\n,3,4,UM,1,123,2,23,\n"
                       ",3,3\n"));
}

TEST(Relations, RigidElementsOfSharedEnds) {
  expect_rigid(deck_of(corners + "RBAR,5,1,2,1236,45\n"));
  expect_rigid(deck_of(corners + "RBE1,5,1,123,2,23,3,3\n,UM,9,123456\n"));
  const Deck rod = deck_of(corners + "RROD,5,1,3,2\n");
  const System system = assemble(rod);
  const VectorXd u = system.T * VectorXd::Random(system.dofs());
  const Vector3d along = rod.grids[2].position - rod.grids[0].position;
  EXPECT_NEAR(along.dot(u.segment<3>(12) - u.segment<3>(0)), 0.0, 1e-14);
}

TEST(Relations, Rbe3SharesAForceByWeights) {
  // Weights 1 and 3: a force at the reference grid goes to the ends 1 : 3.
  const Deck deck = deck_of(
      "GRID,1,,0.,0.,0.\nGRID,2,,4.,0.,0.\nGRID,9,,3.,0.,0.\n"
      "RBE3,7,,9,2,1.,2,1,3.\n,2,2\n");
  const System system = assemble(deck);
  const MatrixXd T = system.T;
  EXPECT_NEAR(T(13, 1), 0.25, 1e-12);
  EXPECT_NEAR(T(13, 7), 0.75, 1e-12);
}

TEST(Relations, MpcIsItsEquation) {
  // 2 u1 - u2 = 0 on two masses: k u1^2 = w^2 (m1 u1^2 + m2 4 u1^2).
  const std::string masses =
      "SPOINT,1,2\nCELAS4,11,100.,1\nCMASS4,12,1.,1\nCMASS4,13,2.,2\n";
  const Deck deck =
      deck_of("GRID,5,,0.,0.,0.,,123456\n" + masses + "MPC,3,1,0,2.,2,0,-1.\n");
  const double hz = std::sqrt(100.0 / 9.0) / (2 * M_PI);
  // u2 = 2 u1 with the first term dependent: u1 = u2 / 2.
  EXPECT_NEAR(modes_of(deck, 1).frequency_hz(0), hz, 1e-9 * hz);
}

TEST(Relations, CaseControlSelects) {
  const std::string model =
      "GRID,5,,0.,0.,0.,,123456\nSPOINT,1,2\nCELAS4,11,100.,1\n"
      "CELAS4,14,50.,2\nCMASS4,12,1.,1\nCMASS4,13,2.,2\n"
      "MPC,3,1,0,1.,2,0,-1.\nMPC,4,1,0,1.,2,0,1.\nMPCADD,8,3\nENDDATA\n";
  const auto count = [&](const std::string& control) {
    return deck_of(control + "BEGIN BULK\n" + model).relations.size();
  };
  EXPECT_EQ(count("MPC = 3\n"), 1U);
  EXPECT_EQ(count("MPC = 8\n"), 1U);
  EXPECT_EQ(count("SUBCASE 1\nMPC = 4\nSUBCASE 2\nMPC = 3\n"), 1U);
  const Deck all = deck_of("CEND\nBEGIN BULK\n" + model);
  EXPECT_EQ(all.relations.size(), 2U);
  EXPECT_THAT(all.warnings[0], HasSubstr("2 sets of MPC"));
}

TEST(Relations, AlongTurnedAxesAndInOtherUnits) {
  const std::string model =
      "CORD2R,7,,0.,0.,0.,0.,0.,1.\n,.8,.6,0.\n"
      "GRID,1,,0.,0.,0.,7\nGRID,2,,300.,0.,0.\nGRID,9,,100.,50.,20.,7\n"
      "MPC,1,9,1,1.,1,6,-25.\n,,2,1,-.5\n";
  Deck deck = deck_of(model);
  scale_to_si(deck, "mm-t-s");
  // A millimetre per radian is a metre per thousand.
  EXPECT_NEAR(deck.relations[0].terms[0].factor, 0.025, 1e-15);
  EXPECT_NEAR(deck.relations[0].terms[1].factor, 0.5, 1e-15);
  const System system = assemble(deck);
  const VectorXd u = system.T * VectorXd::Random(system.dofs());
  const Vector3d x(0.8, 0.6, 0.0);
  EXPECT_NEAR(x.dot(u.segment<3>(12)), 0.025 * u(5) + 0.5 * u(6), 1e-14);
}

TEST(Relations, FaultsAreNamed) {
  const auto expect = [](const std::string& cards, const std::string& what) {
    try {
      static_cast<void>(assemble(deck_of(corners + cards)));
      ADD_FAILURE() << cards;
    } catch (const InputError& error) {
      EXPECT_THAT(error.what(), HasSubstr(what)) << cards;
      EXPECT_THAT(error.where(), HasSubstr("model.bdf:")) << cards;
    }
  };
  expect("RBE3,7,,9,123456,1.,123,1,2\n", "do not determine component 2");
  expect("RBE3,7,,9,123,1.,123\n", "averages no grid");
  expect("RBE3,7,,9,123,1.,123,1,77\n", "grid 77 does not exist");
  expect("MPC,1,1,1,0.,2,1,1.\n", "first term is zero");
  expect("MPC,1,1,1,1.,1,1,2.\n", "named twice");
  // A ring: 9 follows 1 to 4, and 1 follows 9.
  expect("RBE3,7,,9,123,1.,123,1,2,\n,3,4\nMPC,1,1,1,1.,9,1,-1.\n",
         "follows itself");
}

TEST(DirectMatrices, AreAddedWhereTheCaseControlNamesThem) {
  const std::string model =
      "GRID,1,,0.,0.,0.,,23456\nGRID,2,,1.,0.,0.,,23456\nCMASS2,5,2.,1,1\n"
      "CMASS2,6,2.,2,1\nCELAS2,7,10.,1,1\n"
      "DMIG,KX,0,6,1,0\nDMIG,KX,1,1,,1,1,30.\n,2,1,-30.\n"
      "DMIG,KX,2,1,,2,1,30.\nENDDATA\n";
  const Deck deck = deck_of("K2GG = KX\nBEGIN BULK\n" + model);
  const MatrixXd K = assemble(deck).K;
  EXPECT_DOUBLE_EQ(K(0, 0), 40.0);
  EXPECT_DOUBLE_EQ(K(0, 6), -30.0);
  EXPECT_DOUBLE_EQ(K(6, 0), -30.0);
  EXPECT_DOUBLE_EQ(K(6, 6), 30.0);
  const Deck none = deck_of("CEND\nBEGIN BULK\n" + model);
  EXPECT_TRUE(none.stiffness_terms.empty());
  EXPECT_THAT(none.warnings[0], HasSubstr("DMIG KX is left out"));
}

// A reduced model in a file of its own has usual names and no case control;
// where one chooses, what it does not choose is not in the model, as in
// Nastran.
TEST(DirectMatrices, OfUsualNamesAreTakenWithoutACaseControl) {
  const auto deck = [](const std::string& control) {
    return deck_of(control +
                   "BEGIN BULK\nGRID,1,,0.,0.,0.,,23456\nCMASS2,5,2.,1,1\n"
                   "DMIG,KAAX,0,6,1,0\nDMIG,KAAX,1,1,,1,1,30.\nENDDATA\n");
  };
  const Deck alone = deck("");
  ASSERT_EQ(alone.stiffness_terms.size(), 1U);
  EXPECT_THAT(alone.warnings[0],
              HasSubstr("DMIG KAAX is taken as stiffness for its name"));
  for (const char* control :
       {"SOL 103\nCEND\nMETHOD = 1\n", "SOL 103\nCEND\nK2PP = KAAX\n"}) {
    const Deck other = deck(control);
    EXPECT_TRUE(other.stiffness_terms.empty()) << control;
    EXPECT_THAT(other.warnings, Contains(HasSubstr("DMIG KAAX is left out")));
  }
}

constexpr const char* two_springs =
    "BEGIN BULK\nGRID,1,,0.,0.,0.,,23456\nGRID,2,,1.,0.,0.,,23456\n"
    "CMASS2,5,2.,1,1\nCMASS2,6,2.,2,1\n";

TEST(DirectMatrices, AreTakenTimesAFactor) {
  const Deck deck = deck_of("K2GG = 2.5*KX\n" + std::string(two_springs) +
                            "DMIG,KX,0,6,1,0\nDMIG,KX,1,1,,1,1,30.\nENDDATA\n");
  EXPECT_DOUBLE_EQ(assemble(deck).K.coeff(0, 0), 75.0);
  for (const std::string& text : deck.warnings) {
    EXPECT_EQ(text.find("left out"), std::string::npos) << text;
  }
}

// Both triangles of a square one, and one whose triangles differ.
TEST(DirectMatrices, MayBeSquareWhereTheyAreSymmetric) {
  const auto deck = [](const std::string& other) {
    return deck_of("K2GG = KX\n" + std::string(two_springs) +
                   "DMIG,KX,0,1,1,0\nDMIG,KX,1,1,,1,1,30.,,\n,2,1,-20.\n"
                   "DMIG,KX,2,1,,1,1," +
                   other + ",,\n,2,1,40.\nENDDATA\n");
  };
  const MatrixXd K = assemble(deck("-20.")).K;
  EXPECT_DOUBLE_EQ(K(0, 0), 30.0);
  EXPECT_DOUBLE_EQ(K(0, 6), -20.0);
  EXPECT_DOUBLE_EQ(K(6, 0), -20.0);
  EXPECT_DOUBLE_EQ(K(6, 6), 40.0);
  EXPECT_THROW(static_cast<void>(deck("-10.")), InputError);
}

TEST(DirectMatrices, AreMissedWhereTheCaseControlNamesThem) {
  try {
    static_cast<void>(
        deck_of("K2GG = KX\n" + std::string(two_springs) + "ENDDATA\n"));
    ADD_FAILURE() << "accepted";
  } catch (const InputError& error) {
    EXPECT_THAT(error.what(), HasSubstr("KX, which no DMIG"));
  }
}

}  // namespace
}  // namespace tapfit::structure
