// Blocks of bricks with all that joins and holds them, against CalculiX 2.20
// (ccx) on the same decks: the elements are the same, so frequencies agree to
// the digits that it prints.
#include "tests/updating/support/inp_bricks.hpp"
#include "tests/updating/support/inp_support.hpp"

namespace tapfit::structure {
namespace {

const std::string wood_inp =
    "*MATERIAL, NAME=WOOD\n*ELASTIC, TYPE=ENGINEERING CONSTANTS\n"
    "1.2e10, 6e8, 6e8, .3, .3, .4, 8e8, 8e8,\n3e8\n*DENSITY\n500.\n";

// A block of four bricks, fixed at one end, with more lines.
struct Block {
  std::string more_nodes = "";
  std::string more = "";
  std::string section = brick_section;
  std::string steps = "*STEP\n*FREQUENCY\n8\n*END STEP\n";
};

std::string text_of(const Block& block) {
  const BrickText b = bricks({});
  return "*NODE\n" + b.nodes + block.more_nodes +
         "*ELEMENT, TYPE=C3D20, ELSET=V\n" + b.elements +
         set_of_nodes("ROOT", b.root) + set_of_nodes("TIP", b.tip) +
         block.section + block.more + "*BOUNDARY\nROOT, 1, 3\n" + block.steps;
}

void expect_hz(const Deck& deck, const std::vector<double>& expected) {
  const auto n = static_cast<Eigen::Index>(expected.size());
  const Eigen::VectorXd hz = hz_of(deck, n);
  ASSERT_EQ(hz.size(), n);
  for (Eigen::Index k = 0; k < n; ++k) {
    const double wanted = expected[static_cast<std::size_t>(k)];
    EXPECT_NEAR(hz(k), wanted, 1e-4 * wanted) << k;
  }
}

const std::string load_at_tip =
    "*ELEMENT, TYPE=MASS, ELSET=M\n9001, 9001\n*MASS, ELSET=M\n5.\n";
const std::string reference_nodes = "9001, .5, .05, .05\n9002, .5, .05, .05\n";

TEST(InpSolids, CantileverOfBricks) {
  const Deck deck = deck_of_inp(text_of({}));
  EXPECT_EQ(deck.solids.size(), 4U);
  expect_hz(deck, {518.24, 518.24, 2011.2, 2662.2, 2662.2});
}

TEST(InpSolids, OrthotropicAlongAxesOfItsOwn) {
  Block block;
  block.section =
      "*SOLID SECTION, ELSET=V, MATERIAL=WOOD, ORIENTATION=OR\n"
      "*ORIENTATION, NAME=OR, SYSTEM=RECTANGULAR\n1., .5, 0., -.5, 1., 0.\n" +
      wood_inp;
  expect_hz(deck_of_inp(text_of(block)),
            {250.57, 275.93, 825.80, 1181.2, 1184.8});
}

TEST(InpSolids, RigidBodyTurnsByItsRotNode) {
  Block block;
  block.more_nodes = reference_nodes;
  block.more = load_at_tip +
               "*RIGID BODY, NSET=TIP, REF NODE=9001, ROT NODE=9002\n"
               "*BOUNDARY\n9002, 1, 1\n";
  const Deck deck = deck_of_inp(text_of(block));
  EXPECT_FALSE(deck.has_grid(9002));
  expect_hz(deck, {351.72, 351.72, 1759.8, 1759.8, 2831.2});
}

TEST(InpSolids, KinematicCouplingOfASurface) {
  Block block;
  block.more_nodes = reference_nodes;
  block.more = load_at_tip +
               "*SURFACE, NAME=TS, TYPE=NODE\nTIP\n"
               "*COUPLING, CONSTRAINT NAME=C, REF NODE=9001, SURFACE=TS\n"
               "*KINEMATIC\n1, 3\n";
  const std::vector<double> expected{351.72, 351.72, 1759.8, 1759.8, 2011.2};
  expect_hz(deck_of_inp(text_of(block)), expected);
  block.more = load_at_tip + "*KINEMATIC COUPLING, REF NODE=9001\nTIP, 1, 3\n";
  expect_hz(deck_of_inp(text_of(block)), expected);
}

// The tip carries the mass, and is no stiffer: below the rigid one in all.
TEST(InpSolids, DistributingCouplingIsAMean) {
  Block block;
  block.more_nodes = reference_nodes;
  block.more = load_at_tip +
               "*ELSET, ELSET=END\n4\n*SURFACE, NAME=TS\nEND, S4\n"
               "*COUPLING, CONSTRAINT NAME=C, REF NODE=9001, SURFACE=TS\n"
               "*DISTRIBUTING\n1, 6\n";
  const Deck deck = deck_of_inp(text_of(block));
  EXPECT_EQ(deck.relations.size(), 6U);
  const Eigen::VectorXd hz = hz_of(deck, 4);
  EXPECT_LT(hz(0), 351.72);
  EXPECT_GT(hz(0), 345.0);
  EXPECT_LT(hz(2), 1759.8);
  EXPECT_TRUE(warns(deck, "count alike"));
}

// By the definition: u = sum w u_k / sum w in each of three directions.
TEST(InpSolids, DistributingCouplingOfAnElementIsAWeightedMean) {
  Block block;
  block.more_nodes = reference_nodes;
  const std::vector<int>& tip = bricks({}).tip;
  block.more =
      load_at_tip + "*ELEMENT, TYPE=DCOUP3D, ELSET=D\n9500, 9001\n" +
      fmt::format(
          "*DISTRIBUTING COUPLING, ELSET=D\n{}, 1.\n{}, 3.\n", tip[0], tip[1]);
  const Deck deck = deck_of_inp(text_of(block));
  ASSERT_EQ(deck.relations.size(), 3U);
  for (int k = 0; k < 3; ++k) {
    const Relation& mean = deck.relations[static_cast<std::size_t>(k)];
    EXPECT_EQ(mean.grid, 9001);
    EXPECT_EQ(mean.component, k + 1);
    ASSERT_EQ(mean.terms.size(), 2U);
    EXPECT_NEAR(mean.terms[0].factor, 0.25, 1e-12);
    EXPECT_NEAR(mean.terms[1].factor, 0.75, 1e-12);
  }
  EXPECT_TRUE(warns(deck, "as in CalculiX"));
}

// Two bricks side by side about the z axis: x of the first's middle is at 0
// degrees, of the second's at 90.
TEST(InpSolids, CylindricalAxesAreThoseOfEachElement) {
  const Deck deck = deck_of_inp(
      "*NODE\n1, 1., -1., 0.\n2, 2., -1., 0.\n3, 2., 1., 0.\n4, 1., 1., 0.\n"
      "5, 1., -1., 1.\n6, 2., -1., 1.\n7, 2., 1., 1.\n8, 1., 1., 1.\n"
      "11, -1., 1., 0.\n12, 1., 1., 0.\n13, 1., 2., 0.\n14, -1., 2., 0.\n"
      "15, -1., 1., 1.\n16, 1., 1., 1.\n17, 1., 2., 1.\n18, -1., 2., 1.\n"
      "*ELEMENT, TYPE=C3D8, ELSET=V\n1, 1, 2, 3, 4, 5, 6, 7, 8\n"
      "2, 11, 12, 13, 14, 15, 16, 17, 18\n"
      "*ORIENTATION, NAME=O, SYSTEM=CYLINDRICAL\n0., 0., 0., 0., 0., 1.\n"
      "*SOLID SECTION, ELSET=V, MATERIAL=M, ORIENTATION=O\n"
      "*MATERIAL, NAME=M\n*ELASTIC, TYPE=ENGINEERING CONSTANTS\n"
      "1.4e11, 1e10, 1e10, .3, .3, .4, 5e9, 5e9,\n3e9\n*DENSITY\n1600.\n");
  ASSERT_EQ(deck.solids.size(), 2U);
  const auto radial = [&](std::size_t k) {
    return Eigen::Vector3d(
        deck.solid_properties.at(deck.solids[k].property).axes.col(0));
  };
  EXPECT_LT((radial(0) - Eigen::Vector3d::UnitX()).norm(), 1e-12);
  EXPECT_LT((radial(1) - Eigen::Vector3d::UnitY()).norm(), 1e-12);
  EXPECT_TRUE(warns(deck, "axes of its middle"));
  EXPECT_TRUE(warns(deck, "C3D8 bends freely"));
}

TEST(InpSolids, EquationsAlongTransformedAxes) {
  const BrickText b = bricks({});
  Block block;
  block.more =
      "*TRANSFORM, NSET=TIP, TYPE=R\n1., 1., 0., -1., 1., 0.\n"
      "*BOUNDARY\nTIP, 1\n*EQUATION\n";
  for (std::size_t k = 1; k < b.tip.size(); ++k) {
    block.more += fmt::format("2\n{}, 2, 1., {}, 2, -1.\n", b.tip[k], b.tip[0]);
  }
  expect_hz(deck_of_inp(text_of(block)),
            {791.94, 2096.0, 3436.1, 3533.4, 3833.6});
}

TEST(InpSolids, CylindricalTransform) {
  Block block;
  block.more =
      "*TRANSFORM, NSET=TIP, TYPE=C\n.4, -.3, 0., .4, -.3, 1.\n"
      "*BOUNDARY\nTIP, 2\n";
  expect_hz(deck_of_inp(text_of(block)),
            {789.32, 789.32, 2011.2, 3519.7, 3519.7});
}

TEST(InpSolids, TieOfMeshesThatDoNotMeet) {
  const BrickText other = bricks({{2, 2, 3}, {0.2, 0.1, 0.1}, 0.4, 501, 101});
  Block block;
  block.more_nodes = other.nodes;
  block.more = "*ELEMENT, TYPE=C3D20, ELSET=V\n" + other.elements +
               "*ELSET, ELSET=A\n4\n*ELSET, ELSET=B, GENERATE\n101, 106\n"
               "*SURFACE, NAME=MS\nA, S4\n*SURFACE, NAME=SS\nB, S6\n"
               "*TIE, NAME=T, POSITION TOLERANCE=.01\nSS, MS\n";
  expect_hz(deck_of_inp(text_of(block)),
            {233.27, 233.28, 1319.5, 1319.6, 1336.7});
}

TEST(InpSolids, TieOfNodesAtOnePlace) {
  const BrickText other = bricks({{1, 1, 1}, {0.1, 0.1, 0.1}, 0.4, 501, 101});
  Block block;
  block.more_nodes = other.nodes;
  block.more = "*ELEMENT, TYPE=C3D20, ELSET=V\n" + other.elements +
               set_of_nodes("NEW", other.root) +
               "*SURFACE, NAME=MS, TYPE=NODE\nTIP\n"
               "*SURFACE, NAME=SS, TYPE=NODE\nNEW\n*TIE, NAME=T\nSS, MS\n";
  const Deck tied = deck_of_inp(text_of(block));
  EXPECT_EQ(tied.relations.size(), 3U * other.root.size());
  // As five bricks in one mesh.
  const BrickText whole = bricks({{5, 1, 1}, {0.5, 0.1, 0.1}});
  const Deck one =
      deck_of_inp("*NODE\n" + whole.nodes + "*ELEMENT, TYPE=C3D20, ELSET=V\n" +
                  whole.elements + set_of_nodes("ROOT", whole.root) +
                  brick_section + "*BOUNDARY\nROOT, 1, 3\n");
  const Eigen::VectorXd expected = hz_of(one, 6);
  EXPECT_LT((hz_of(tied, 6) - expected).cwiseAbs().maxCoeff(),
            1e-6 * expected(5));
}

TEST(InpSolids, SlaveNodesOffTheFaceAreNamed) {
  const BrickText other = bricks({{1, 1, 1}, {0.1, 0.1, 0.1}, 0.5, 501, 101});
  Block block;
  block.more_nodes = other.nodes;
  block.more = "*ELEMENT, TYPE=C3D20, ELSET=V\n" + other.elements +
               "*SURFACE, NAME=MS\n4, S4\n*SURFACE, NAME=SS\n101, S6\n"
               "*TIE, NAME=T\nSS, MS\n";
  EXPECT_TRUE(warns(deck_of_inp(text_of(block)), "8 of 8 nodes"));
}

}  // namespace
}  // namespace tapfit::structure
