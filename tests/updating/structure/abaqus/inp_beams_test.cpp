// Beams: sections by closed forms, cantilevers by Euler's,
//
//   f_1 = 1.8751^2 / (2 pi L^2) sqrt(E I / (rho A)),
//
// springs and masses by hand.
#include "tests/updating/support/inp_support.hpp"

#include <cmath>
#include <numbers>

namespace tapfit::structure {
namespace {

using std::numbers::pi;

std::string bending_inp(const std::string& type,
                        int elements,
                        const std::string& section) {
  const bool quadratic = type.starts_with("B32");
  const int n = quadratic ? 2 * elements : elements;
  std::string text =
      line_of_nodes(n, 1.0) + "*ELEMENT, TYPE=" + type + ", ELSET=B\n";
  for (int k = 0; k < elements; ++k) {
    text +=
        quadratic
            ? fmt::format(
                  "{}, {}, {}, {}\n", k + 1, 2 * k + 1, 2 * k + 2, 2 * k + 3)
            : fmt::format("{}, {}, {}\n", k + 1, k + 1, k + 2);
  }
  return text + steel_inp + section + "*BOUNDARY\n1, 1, 6\n";
}

double euler_hz(double radius_of_gyration) {
  constexpr double root = 1.875104;
  return root * root / (2.0 * pi) * std::sqrt(2.1e11 / 7800.0) *
         radius_of_gyration;
}

// Slender: shear and rotary inertia take 0.1 % at most.
TEST(InpBeams, CantileversBendAsEulerHasIt) {
  const std::string rect =
      "*BEAM SECTION, ELSET=B, MATERIAL=STEEL, SECTION=RECT\n.03, .02\n"
      "0., 1., 0.\n";
  for (const auto& [type, count] :
       {std::pair{"B31", 20}, {"B31R", 20}, {"B32", 10}, {"B32R", 10}}) {
    const Deck deck = deck_of_inp(bending_inp(type, count, rect));
    EXPECT_EQ(deck.bars.size(), 20U);
    const Eigen::VectorXd hz = hz_of(deck, 2);
    // a = 0.03 lies along n1 = y.
    EXPECT_NEAR(hz(0), euler_hz(0.02 / std::sqrt(12.0)), 2e-3 * hz(0));
    EXPECT_NEAR(hz(1), euler_hz(0.03 / std::sqrt(12.0)), 2e-3 * hz(1));
  }
}

TEST(InpBeams, SectionWithoutDirectionHasMinusZ) {
  const Deck deck = deck_of_inp(bending_inp(
      "B31",
      4,
      "*BEAM SECTION, ELSET=B, MATERIAL=STEEL, SECTION=RECT\n.03, .02\n"));
  EXPECT_EQ(deck.bars[0].orientation, -Eigen::Vector3d::UnitZ());
}

TEST(InpBeams, ExtraNodeGivesTheDirection) {
  const Deck deck = deck_of_inp(
      "*NODE\n1, 0., 0., 0.\n2, 1., 0., 0.\n3, 0., 2., 0.\n"
      "*ELEMENT, TYPE=B31, ELSET=B\n1, 1, 2, 3\n" +
      steel_inp +
      "*BEAM SECTION, ELSET=B, MATERIAL=STEEL, SECTION=RECT\n.03, .02\n");
  EXPECT_LT(
      (deck.bars[0].orientation.normalized() - Eigen::Vector3d::UnitY()).norm(),
      1e-12);
}

// The property and the only bar of a beam along x with n1 = y.
struct OneBeam {
  BarProperty section;
  Bar bar;
};

OneBeam beam_of(const std::string& type, const std::string& dimensions) {
  const Deck deck =
      deck_of_inp(bending_inp("B31",
                              1,
                              "*BEAM SECTION, ELSET=B, MATERIAL=STEEL, "
                              "SECTION=" +
                                  type + "\n" + dimensions + "\n0., 1., 0.\n"));
  return {deck.bar_properties.begin()->second, deck.bars.front()};
}

TEST(InpBeams, CirclesOfBothPrograms) {
  for (const char* dimensions : {"0.02", "0.04, 0.04"}) {
    const BarProperty p = beam_of("CIRC", dimensions).section;
    EXPECT_NEAR(p.area, pi * 4e-4, 1e-15);
    EXPECT_NEAR(p.I1, pi / 4.0 * 1.6e-7, 1e-18);
    EXPECT_NEAR(p.J, pi / 2.0 * 1.6e-7, 1e-18);
  }
}

// pi a b, pi a^3 b / 4, pi a^3 b^3 / (a^2 + b^2).
TEST(InpBeams, EllipseOfTwoDiameters) {
  const BarProperty p = beam_of("CIRC", "0.06, 0.02").section;
  constexpr double digits = 1e-9;  // of a field
  EXPECT_NEAR(p.area / (pi * 3e-4), 1.0, digits);
  EXPECT_NEAR(p.I1 / (pi / 4.0 * 27e-6 * 0.01), 1.0, digits);
  EXPECT_NEAR(p.I2 / (pi / 4.0 * 1e-6 * 0.03), 1.0, digits);
  EXPECT_NEAR(p.J / (pi * 27e-12 / 1e-3), 1.0, digits);
}

TEST(InpBeams, SectionsByHand) {
  const BarProperty rect = beam_of("RECT", "0.03, 0.02").section;
  EXPECT_NEAR(rect.I1, 0.02 * std::pow(0.03, 3) / 12.0, 1e-18);
  EXPECT_NEAR(rect.I2, 0.03 * std::pow(0.02, 3) / 12.0, 1e-18);
  const BarProperty pipe = beam_of("PIPE", "0.02, 0.004").section;
  EXPECT_NEAR(pipe.area, pi * (4e-4 - 2.56e-4), 1e-15);
  EXPECT_NEAR(pipe.J, pi / 2.0 * (1.6e-7 - std::pow(0.016, 4)), 1e-18);
  const BarProperty box = beam_of("BOX", "50., 50., 3., 3., 3., 3.").section;
  EXPECT_NEAR(box.area, 564.0, 1e-9);
  EXPECT_NEAR(box.I1, (std::pow(50.0, 4) - std::pow(44.0, 4)) / 12.0, 1e-6);
  EXPECT_NEAR(box.J, std::pow(47.0, 3) * 3.0, 1e-6);  // Bredt
  const BarProperty general = beam_of("GENERAL", "1., 2., 0.5, 3., 4.").section;
  EXPECT_EQ(general.I2, 2.0);  // I11: about axis 1
  EXPECT_EQ(general.I1, 3.0);
  EXPECT_EQ(general.I12, 0.5);
  EXPECT_EQ(general.J, 4.0);
}

// Walls of 4 at +1 and of 2 at -1, 3 at +2 and 1 at -2: the centroid by hand.
TEST(InpBeams, UnequalWallsOfABox) {
  const OneBeam beam = beam_of("BOX", "40., 30., 4., 3., 2., 1.");
  const double area = 40.0 * 30.0 - 34.0 * 26.0;
  EXPECT_NEAR(beam.section.area, area, 1e-9);
  const double y =
      (4 * 30 * 18.0 - 2 * 30 * 19.0 - 34 * 3 * 1.0 - 34 * 1 * 1.0) / area;
  const double z = (40 * 3 * 13.5 - 40 * 1 * 14.5 - 6 * 26 * 1.0) / area;
  EXPECT_NEAR(beam.bar.offsets[0].y(), y, 1e-9);
  EXPECT_NEAR(beam.bar.offsets[0].z(), z, 1e-9);
}

// A wall as thin as nothing leaves the open section's J.
TEST(InpBeams, OpenBoxTwistsAsItsWalls) {
  const double J = beam_of("BOX", "25., 50., .0001, 3., 3., 3.").section.J;
  EXPECT_NEAR(J, (50.0 + 2.0 * 22.0) * 27.0 / 3.0, 1.0);
}

// The height lies along n2 = z, the nodes 1 above the lower edge.
TEST(InpBeams, HeightOfAnIStandsOnAxisTwo) {
  const OneBeam beam = beam_of("I", "1., 10., 4., 4., 1., 1., 2.");
  EXPECT_NEAR(beam.section.area, 24.0, 1e-12);
  EXPECT_NEAR(beam.section.I1,
              2.0 * (4.0 / 12.0 + 4.0 * 4.5 * 4.5) + 2.0 * 512.0 / 12.0,
              1e-9);
  EXPECT_LT((beam.bar.orientation - Eigen::Vector3d::UnitZ()).norm(), 1e-12);
  EXPECT_LT((beam.bar.offsets[0] - Eigen::Vector3d(0.0, 0.0, 4.0)).norm(),
            1e-12);
}

// Of flanges of 8 and 4 the centroid lies where it does by hand.
TEST(InpBeams, CentroidOfAnIWithUnequalFlanges) {
  const OneBeam beam = beam_of("I", "0., 10., 8., 4., 1., 1., 2.");
  const double height = (8.0 * 0.5 + 16.0 * 5.0 + 4.0 * 9.5) / 28.0;
  EXPECT_NEAR(beam.bar.offsets[0].z() + beam.section.neutral.x(), height, 1e-9);
}

TEST(InpBeams, SectionsThatAreNone) {
  const auto refused = [](const char* type, const char* dimensions) {
    return [=] { static_cast<void>(beam_of(type, dimensions)); };
  };
  EXPECT_THAT(refused("RECT", "1."), Refuses("dimension of the section"));
  EXPECT_THAT(refused("RECT", "1., -1."), Refuses("give no section"));
  EXPECT_THAT(refused("PIPE", "1., 2."), Refuses("give no section"));
  EXPECT_THAT(refused("HEX", "1., 2."), Refuses("section HEX is not read"));
}

TEST(InpBeams, GeneralSectionHasModuliOfItsOwn) {
  const Deck deck = deck_of_inp(
      line_of_nodes(20, 1.0) + "*ELEMENT, TYPE=B31, ELSET=B\n" +
      [] {
        std::string text;
        for (int k = 1; k <= 20; ++k) {
          text += fmt::format("{}, {}, {}\n", k, k, k + 1);
        }
        return text;
      }() +
      "*BEAM GENERAL SECTION, ELSET=B, SECTION=GENERAL, DENSITY=7800.\n"
      "6.e-4, 2.e-8, 0., 4.5e-8, 4.6e-8\n0., 1., 0.\n2.1e11, 8.08e10\n"
      "*BOUNDARY\n1, ENCASTRE\n");
  const Eigen::VectorXd hz = hz_of(deck, 2);
  EXPECT_NEAR(hz(0), euler_hz(std::sqrt(2e-8 / 6e-4)), 2e-3 * hz(0));
  EXPECT_NEAR(hz(1), euler_hz(std::sqrt(4.5e-8 / 6e-4)), 2e-3 * hz(1));
}

// As ccx 2.20 expands it: OFFSET1 = 0.5 puts the nodes on the side at +n1.
TEST(InpBeams, OffsetPutsTheAxisBesideTheNodes) {
  const Deck deck = deck_of_inp(bending_inp(
      "B31",
      1,
      "*BEAM SECTION, ELSET=B, MATERIAL=STEEL, SECTION=RECT, OFFSET1=.5, "
      "OFFSET2=.25\n.3, .2\n0., 1., 0.\n"));
  const Eigen::Vector3d expected(0.0, -0.15, -0.05);
  EXPECT_LT((deck.bars[0].offsets[0] - expected).norm(), 1e-12);
  EXPECT_LT((deck.bars[0].offsets[1] - expected).norm(), 1e-12);
}

TEST(InpBeams, DirectionAlongTheBeamIsRefused) {
  EXPECT_THAT(
      [] {
        deck_of_inp(bending_inp(
            "B31",
            1,
            "*BEAM SECTION, ELSET=B, MATERIAL=STEEL, SECTION=RECT\n.3, .2\n"
            "1., 0., 0.\n"));
      },
      Refuses("lies along the beam"));
}

TEST(InpBeams, TrussIsARod) {
  const Deck deck = deck_of_inp(
      line_of_nodes(2, 1.0) + "*ELEMENT, TYPE=T3D2, ELSET=T\n1, 1, 2\n" +
      "*ELEMENT, TYPE=T3D3, ELSET=T\n2, 1, 2, 3\n" + steel_inp +
      "*SOLID SECTION, ELSET=T, MATERIAL=STEEL\n1.e-4\n");
  ASSERT_EQ(deck.rods.size(), 2U);
  EXPECT_EQ(deck.rods[1].grids, (std::array<int, 2>{1, 3}));
  EXPECT_EQ(deck.rod_properties.begin()->second.area, 1e-4);
}

// K = [[3000, -2000], [-2000, 2500]], M = 2: 367.2 and 2382.8 1/s^2.
TEST(InpBeams, ChainOfSpringsAndMasses) {
  const Deck deck = deck_of_inp(
      "*NODE\n1, 0., 0., 0.\n2, 1., 0., 0.\n3, 2., 0., 0.\n"
      "*ELEMENT, TYPE=SPRINGA, ELSET=K1\n1, 1, 2\n"
      "*ELEMENT, TYPE=SPRING2, ELSET=K2\n2, 2, 3\n"
      "*ELEMENT, TYPE=SPRING1, ELSET=K3\n3, 3\n"
      "*ELEMENT, TYPE=MASS, ELSET=M\n4, 2\n5, 3\n"
      "*ELEMENT, TYPE=DASHPOTA, ELSET=C\n6, 1, 2\n"
      "*ELEMENT, TYPE=DASHPOT1, ELSET=D\n7, 3\n"
      "*ELEMENT, TYPE=DASHPOT2, ELSET=E\n8, 2, 3\n"
      "*SPRING, ELSET=K1\n\n1000.\n*SPRING, ELSET=K2\n1, 1\n2000.\n"
      "*SPRING, ELSET=K3\n1\n500.\n*MASS, ELSET=M\n2.\n"
      "*DASHPOT, ELSET=C\n\n3.\n*DASHPOT, ELSET=D\n1\n4.\n"
      "*DASHPOT, ELSET=E\n1, 1\n5.\n"
      "*BOUNDARY\n1, 1, 3\n2, 2, 3\n3, 2, 3\n");
  const Eigen::VectorXd hz = hz_of(deck, 2);
  const double half = std::sqrt(1375.0 * 1375.0 - 875000.0);
  EXPECT_NEAR(hz(0), std::sqrt(1375.0 - half) / (2.0 * pi), 1e-6);
  EXPECT_NEAR(hz(1), std::sqrt(1375.0 + half) / (2.0 * pi), 1e-6);
  double damping = 0.0;
  for (const ScalarElement& e : deck.scalars) damping += e.damping;
  EXPECT_EQ(damping, 12.0);
}

TEST(InpBeams, RotaryInertiaIsTheTensor) {
  const Deck deck = deck_of_inp(
      one_brick() + brick_section +
      "*ELEMENT, TYPE=ROTARYI, ELSET=R\n2, 1\n*ROTARY INERTIA, ELSET=R\n"
      "1., 2., 3., .1, .2, .3\n");
  Eigen::Matrix3d expected;
  expected << 1.0, 0.1, 0.2, 0.1, 2.0, 0.3, 0.2, 0.3, 3.0;
  ASSERT_EQ(deck.masses.size(), 1U);
  EXPECT_LT((deck.masses[0].inertia - expected).norm(), 1e-12);
}

}  // namespace
}  // namespace tapfit::structure
