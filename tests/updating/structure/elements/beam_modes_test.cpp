// Bars and rods against closed forms and published decks.
#include "tests/updating/support/deck_support.hpp"
#include "updating/structure/elements/element_matrices.hpp"
#include "updating/structure/solve/factor.hpp"

#include <Eigen/Dense>

#include <cmath>
#include <numbers>

namespace tapfit::structure {
namespace {

using std::numbers::pi;

// A cantilever of n bars along (1, 1, 0), bending planes z and in-plane.
Deck cantilever(int n, const BarProperty& section, bool coupled) {
  Deck deck;
  deck.coupled_mass = coupled;
  deck.materials[1] = {1, false, 210e9, 0.3, 210e9 / 2.6, 7800, 0, 0, 0};
  deck.bar_properties[1] = section;
  const Eigen::Vector3d along = Eigen::Vector3d(1, 1, 0).normalized();
  for (int i = 0; i <= n; ++i) deck.grids.push_back({i + 1, along * i / n});
  for (int i = 1; i <= n; ++i) {
    deck.bars.push_back(make_bar(i, 1, i, i + 1));
  }
  deck.constraints.push_back({1, "123456"});
  return deck;
}

const BarProperty rectangular_section{1, 1, 4e-4, 3e-8, 1e-8, 0.0, 2e-8};

TEST(BeamModes, CantileverIsEulers) {
  const Deck deck = cantilever(10, rectangular_section, true);
  const Eigen::VectorXd f = modes_of(deck, 4).frequency_hz;
  const auto euler = [](double root, double I) {
    return root * root * std::sqrt(210e9 * I / (7800 * 4e-4)) / (2 * pi);
  };
  // Cubic elements, tenth of the length: fourth order error.
  EXPECT_NEAR(f(0) / euler(1.875104, 1e-8), 1.0, 1e-5);
  EXPECT_NEAR(f(1) / euler(1.875104, 3e-8), 1.0, 1e-5);
  EXPECT_NEAR(f(2) / euler(4.694091, 1e-8), 1.0, 1e-4);
  EXPECT_NEAR(f(3) / euler(4.694091, 3e-8), 1.0, 1e-4);
}

TEST(BeamModes, TipDeflectsByBendingAndShear) {
  BarProperty section = rectangular_section;
  section.K1 = 0.8;
  Deck deck = cantilever(1, section, false);
  const ElementMatrices e = bar_matrices(deck, deck.bars[0]);
  const Eigen::MatrixXd tip = e.K.bottomRightCorner<6, 6>();
  Eigen::VectorXd force = Eigen::VectorXd::Zero(6);
  force(2) = 1.0;
  const double w = tip.ldlt().solve(force)(2);
  // Plane 1 holds z: F L^3 / 3 E I1 + F L / (K1 G A).
  const double exact = 1 / (3 * 210e9 * 3e-8) + 1 / (0.8 * 210e9 / 2.6 * 4e-4);
  EXPECT_NEAR(w / exact, 1.0, 1e-9);
}

TEST(BeamModes, TorsionOfACbeam) {
  Deck deck = cantilever(20, rectangular_section, true);
  for (Bar& bar : deck.bars) bar.rotary_inertia = true;
  hold(deck, "123", [](const Eigen::Vector3d&) { return true; });
  deck.constraints.push_back({2, "123"});
  const Eigen::VectorXd f = modes_of(deck, 1).frequency_hz;
  // Fixed-free: sqrt(G J / rho Ip) / 4L; linear elements, 20 of them: second
  // order, (pi/40)^2/24.
  const double exact = std::sqrt(210e9 / 2.6 * 2e-8 / (7800 * 4e-8)) / 4.0;
  EXPECT_NEAR(f(0) / exact, 1.0, 4e-4);
}

TEST(BeamModes, CoupledSectionIsItsPrincipalAxes) {
  // I = R diag(3, 1)e-8 R' by 30 degrees is the same beam turned.
  const double c = std::cos(pi / 6);
  const double s = std::sin(pi / 6);
  BarProperty section = rectangular_section;
  section.I1 = 3e-8 * c * c + 1e-8 * s * s;
  section.I2 = 3e-8 * s * s + 1e-8 * c * c;
  section.I12 = 2e-8 * c * s;
  const Eigen::VectorXd a =
      modes_of(cantilever(4, rectangular_section, true), 4).frequency_hz;
  const Eigen::VectorXd b =
      modes_of(cantilever(4, section, true), 4).frequency_hz;
  EXPECT_LT((a - b).norm(), 1e-9 * a.norm());
}

TEST(BeamModes, ReleasedEndIsAHinge) {
  // Both rotations released at the far end, which is held in translation:
  // a propped cantilever, first root 3.926602.
  Deck deck = cantilever(10, rectangular_section, true);
  deck.bars.back().released[1] = "56";
  deck.constraints.push_back({11, "123456"});
  const Eigen::VectorXd f = modes_of(deck, 1).frequency_hz;
  const double exact = std::pow(3.926602, 2) *
                       std::sqrt(210e9 * 1e-8 / (7800 * 4e-4)) / (2 * pi);
  EXPECT_NEAR(f(0) / exact, 1.0, 1e-4);
}

TEST(BeamModes, OffsetBarHasSixRigidMotions) {
  Deck deck = cantilever(1, rectangular_section, true);
  deck.bars[0].offsets = {Eigen::Vector3d(0, 0.1, 0.2),
                          Eigen::Vector3d(0.1, 0, 0.3)};
  const ElementMatrices e = bar_matrices(deck, deck.bars[0]);
  const Eigen::VectorXd values =
      Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd>(e.K).eigenvalues();
  EXPECT_LT(values.head(6).cwiseAbs().maxCoeff(), 1e-13 * values.maxCoeff());
  EXPECT_GT(values(6), 1e-6 * values.maxCoeff());
}

// Two chords of five 1 m bays, columns numbered bottom then top, six
// verticals, diagonals alternating; lumped mass. The frequencies before
// updating are those of the truss in Table 3 of the Woodbury updating paper.
std::string truss() {
  std::string text = "MAT1,1,7.+10,,.3,2700.\nPROD,1,1,1.-4\n";
  int id = 1;
  const auto rod = [&](int a, int b) {
    text += fmt::format("CROD,{},1,{},{}\n", id++, a, b);
  };
  for (int i = 0; i < 6; ++i) {
    text += fmt::format("GRID,{},,{}.,0.,0.\n", 2 * i + 1, i);
    text += fmt::format("GRID,{},,{}.,1.,0.\n", 2 * i + 2, i);
    rod(2 * i + 1, 2 * i + 2);
  }
  for (int i = 0; i < 5; ++i) {
    rod(2 * i + 1, 2 * i + 3);
    rod(2 * i + 2, 2 * i + 4);
    i % 2 == 0 ? rod(2 * i + 1, 2 * i + 4) : rod(2 * i + 2, 2 * i + 3);
  }
  return text + "SPC1,1,12,1\nSPC1,1,2,11\nSPC1,1,3456,1,THRU,12\n";
}

TEST(BeamModes, TrussOfThePaper) {
  const Eigen::VectorXd f = modes_of(deck_of(truss()), 7).frequency_hz;
  const std::vector<double> published{
      75.68, 140.12, 211.15, 296.72, 353.95, 422.13, 445.13};
  for (std::size_t i = 0; i < published.size(); ++i) {
    // Printed to two decimals; the paper's own rounding is the rest.
    EXPECT_NEAR(f(static_cast<Eigen::Index>(i)) / published[i], 1.0, 2e-4);
  }
}

TEST(BeamModes, SpringAndMassSwingAtTheirFrequency) {
  const Deck deck = deck_of(
      "GRID,1,,0.,0.,0.\nGRID,2,,1.,0.,0.\nCONM2,1,2,,2.\n"
      "CELAS2,2,800.,1,3,2,3\nSPC1,1,123456,1\n");
  const Eigenmodes modes = modes_of(deck, 3);
  ASSERT_EQ(modes.frequency_hz.size(), 1);  // the rest has no stiffness
  EXPECT_NEAR(modes.frequency_hz(0), 20 / (2 * pi), 1e-9);
}

struct Published {
  const char* file;
  std::vector<double> hz;
  double tolerance;
};

TEST(BeamModes, MeetsPublishedNastranResults) {
  const std::filesystem::path folder =
      TAPFIT_SOURCE_DIR "/../shared/data/nastran-decks";
  if (!std::filesystem::exists(folder)) {
    GTEST_SKIP() << folder << " is not here";
  }
  // pt145 to the seven printed digits; satk within its section's shear factor;
  // goland's shells hold the rotation about their normals more than Nastran's.
  const std::vector<Published> cases{
      {"pt145_swept_wing_CBAR/pt145.bdf",
       {39.96147, 236.4137, 250.4423, 701.4011, 703.4198, 1153.105},
       5e-7},
      {"satk_CBAR_CONM2/pn_mwe_s-solution_1.dat",
       {89.56075, 89.56075, 1044.760},
       5e-5},
      {"good_sine_CBAR_CBUSH_CONM2/good_sine.dat",
       {0, 0, 0, 0, 0, 0, 10.41889, 20.83568, 63.25364, 126.4067, 176.3268},
       1e-5},
      {"goland_CQUAD4_CROD_CONM2_SOL200/goland_final_test.bdf",
       {1.981382},
       2e-4}};
  for (const Published& c : cases) {
    const Eigenmodes modes = modes_of(read_deck(folder / c.file),
                                      static_cast<Eigen::Index>(c.hz.size()));
    for (std::size_t i = 0; i < c.hz.size(); ++i) {
      if (c.hz[i] == 0.0) continue;  // rigid: rounding there and here
      EXPECT_NEAR(modes.frequency_hz(static_cast<Eigen::Index>(i)) / c.hz[i],
                  1.0,
                  c.tolerance)
          << c.file;
    }
  }
}

}  // namespace
}  // namespace tapfit::structure
