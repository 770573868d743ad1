// Shells: the cards by hand, plates against CalculiX 2.20 (ccx) on the same
// meshes, which expands shells to bricks.
#include "tests/updating/support/inp_support.hpp"

#include <cmath>
#include <numbers>

namespace tapfit::structure {
namespace {

// nx by ny shells of a by b; S4, or S8R with the middles of the sides.
std::string plate_inp(int nx, int ny, const std::string& type) {
  const bool quadratic = type.starts_with("S8");
  const int step = quadratic ? 2 : 1;
  const auto id = [&](int i, int j) { return 1 + i * (step * ny + 1) + j; };
  std::string nodes = "*NODE, NSET=ALL\n";
  for (int i = 0; i <= step * nx; ++i) {
    for (int j = 0; j <= step * ny; ++j) {
      if (quadratic && i % 2 == 1 && j % 2 == 1) continue;
      nodes += fmt::format("{}, {}, {}, 0.\n",
                           id(i, j),
                           1.0 * i / (step * nx),
                           0.7 * j / (step * ny));
    }
  }
  std::string elements = "*ELEMENT, TYPE=" + type + ", ELSET=P\n";
  int next = 1;
  for (int i = 0; i < step * nx; i += step) {
    for (int j = 0; j < step * ny; j += step) {
      elements += fmt::format("{}, {}, {}, {}, {}",
                              next++,
                              id(i, j),
                              id(i + step, j),
                              id(i + step, j + step),
                              id(i, j + step));
      if (quadratic) {
        elements += fmt::format(",\n{}, {}, {}, {}",
                                id(i + 1, j),
                                id(i + 2, j + 1),
                                id(i + 1, j + 2),
                                id(i, j + 1));
      }
      elements += "\n";
    }
  }
  return nodes + elements;
}

void expect_elastic_hz(const Deck& deck,
                       const std::vector<double>& expected,
                       double tolerance) {
  const Eigen::VectorXd hz = hz_of(deck, 10);
  for (std::size_t k = 0; k < expected.size(); ++k) {
    EXPECT_NEAR(hz(6 + static_cast<Eigen::Index>(k)),
                expected[k],
                tolerance * expected[k])
        << k;
  }
}

// ccx's elements are others; on these meshes both are within 0.5 % of each
// other (S4: 1 %).
TEST(InpShells, FreePlates) {
  const std::string section =
      "*SHELL SECTION, ELSET=P, MATERIAL=STEEL\n.01\n" + steel_inp;
  expect_elastic_hz(deck_of_inp(plate_inp(20, 14, "S4") + section),
                    {47.942, 53.522, 112.31, 113.60},
                    0.01);
  expect_elastic_hz(deck_of_inp(plate_inp(10, 7, "S8R") + section),
                    {47.688, 53.428, 111.05, 113.28},
                    0.005);
}

TEST(InpShells, OrthotropicPlateAlongAnOrientation) {
  expect_elastic_hz(
      deck_of_inp(
          plate_inp(10, 7, "S8R") +
          "*MATERIAL, NAME=WOOD\n*ELASTIC, TYPE=ENGINEERING CONSTANTS\n"
          "1.2e10, 6e8, 6e8, .3, .3, .4, 8e8, 8e8,\n3e8\n*DENSITY\n500.\n"
          "*ORIENTATION, NAME=OR, SYSTEM=RECTANGULAR\n1., .5, 0., -.5, 1., 0.\n"
          "*SHELL SECTION, ELSET=P, MATERIAL=WOOD, ORIENTATION=OR\n.01\n"),
      {14.673, 28.598, 33.371, 47.221},
      0.005);
}

// A laminate of equal layers is the plate.
TEST(InpShells, CompositeOfOneMaterial) {
  const Deck plain =
      deck_of_inp(plate_inp(4, 3, "S4") +
                  "*SHELL SECTION, ELSET=P, MATERIAL=STEEL\n.01\n" + steel_inp);
  const Deck layers =
      deck_of_inp(plate_inp(4, 3, "S4") +
                  "*SHELL SECTION, ELSET=P, COMPOSITE\n.004, 3, STEEL, 30.\n"
                  ".006, 3, STEEL, -20.\n" +
                  steel_inp);
  const Eigen::VectorXd expected = hz_of(plain, 8);
  EXPECT_NEAR(hz_of(layers, 8)(7), expected(7), 0.01 * expected(7));
  const ShellProperty& p = layers.shell_properties.begin()->second;
  ASSERT_EQ(p.plies.size(), 2U);
  EXPECT_EQ(p.plies[0].thickness, 0.004);
  EXPECT_EQ(p.plies[1].theta_deg, -20.0);
  EXPECT_EQ(p.bottom, -0.005);
}

TEST(InpShells, LayersAreTurnedByTheirOrientations) {
  const Deck deck = deck_of_inp(
      one_shell() +
      "*MATERIAL, NAME=CFRP\n*ELASTIC, TYPE=LAMINA\n"
      "1.3e11, 8e9, .3, 5e9, 5e9, 3e9\n*DENSITY\n1600.\n"
      "*ORIENTATION, NAME=UP\n0., 1., 0., -1., 0., 0.\n"
      "*ORIENTATION, NAME=AXES\n1., 0., 0., 0., 1., 0.\n"
      "*SHELL SECTION, ELSET=P, COMPOSITE, ORIENTATION=AXES, OFFSET=.5\n"
      ".001, , CFRP, UP\n.001, , CFRP, AXES\n");
  const ShellProperty& p = deck.shell_properties.begin()->second;
  EXPECT_NEAR(p.plies[0].theta_deg, 90.0, 1e-9);
  EXPECT_NEAR(p.plies[1].theta_deg, 0.0, 1e-9);
  EXPECT_EQ(p.bottom, -0.002);
  const Material& m = deck.materials.begin()->second;
  EXPECT_TRUE(m.orthotropic);
  EXPECT_EQ(m.E2, 8e9);
  EXPECT_EQ(m.G2z, 3e9);
}

// As ccx 2.20 expands it: OFFSET = 0.5 puts the nodes on the top.
TEST(InpShells, OffsetPutsTheMiddleBelowTheNodes) {
  const std::string section =
      "*SHELL SECTION, ELSET=P, MATERIAL=STEEL, OFFSET=";
  for (const auto& [text, offset] : {std::pair{".5", -0.005},
                                     {"SPOS", -0.005},
                                     {"SNEG", 0.005},
                                     {"0.1", -0.001}}) {
    const Deck deck =
        deck_of_inp(one_shell() + section + text + "\n.01\n" + steel_inp);
    EXPECT_NEAR(deck.shells[0].offset, offset, 1e-15) << text;
  }
}

// Without the option ccx 2.20 passes over it (its example shellf).
TEST(InpShells, NodalThicknessCountsWhereTheSectionSaysSo) {
  const std::string nodal = steel_inp + "*NODAL THICKNESS\n1, .02\n2, .02\n";
  const std::string section = "*SHELL SECTION, ELSET=P, MATERIAL=STEEL";
  const Deck with =
      deck_of_inp(one_shell() + section + ", NODAL THICKNESS\n.01\n" + nodal);
  EXPECT_NEAR(with.shells[0].thickness, 0.015, 1e-15);
  const Deck without = deck_of_inp(one_shell() + section + "\n.01\n" + nodal);
  EXPECT_EQ(without.shells[0].thickness, 0.0);
  EXPECT_TRUE(warns(without, "NODAL THICKNESS counts only where"));
  const Deck alone =
      deck_of_inp(one_shell() + section + ", NODAL THICKNESS\n" + nodal);
  EXPECT_EQ(alone.shell_properties.begin()->second.thickness, 0.02);
}

// The axis of the turn is upright, the next one is direction 1.
TEST(InpShells, AxisOfTheTurnChoosesDirectionOne) {
  const auto angle = [](const std::string& turn) {
    const Deck deck = deck_of_inp(
        one_shell() +
        "*MATERIAL, NAME=CFRP\n*ELASTIC, TYPE=LAMINA\n"
        "1.3e11, 8e9, .3, 5e9, 5e9, 3e9\n*DENSITY\n1600.\n"
        "*ORIENTATION, NAME=AXES\n1., 0., 0., 0., 1., 0.\n" +
        turn +
        "*SHELL SECTION, ELSET=P, MATERIAL=CFRP, ORIENTATION=AXES\n.01\n");
    return deck.shells[0].theta_deg;
  };
  EXPECT_NEAR(angle(""), 0.0, 1e-9);
  EXPECT_NEAR(angle("3, 30.\n"), 30.0, 1e-9);
  EXPECT_NEAR(angle("1, 0.\n"), 90.0, 1e-9);
}

TEST(InpShells, MembranesDoNotBend) {
  const Deck deck = deck_of_inp(
      one_shell("M3D4") + "*MEMBRANE SECTION, ELSET=P, MATERIAL=STEEL\n.01\n" +
      steel_inp);
  const ShellProperty& p = deck.shell_properties.begin()->second;
  EXPECT_EQ(p.membrane, 1);
  EXPECT_EQ(p.bending, 0);
}

TEST(InpShells, TypesAndTheirCards) {
  const std::string nodes =
      "*NODE\n1, 0., 0., 0.\n2, 1., 0., 0.\n3, 1., 1., 0.\n4, 0., 1., 0.\n"
      "5, .5, 0., 0.\n6, 1., .5, 0.\n7, .5, 1., 0.\n8, 0., .5, 0.\n"
      "9, .5, .5, 0.\n";
  const std::string section =
      "*SHELL SECTION, ELSET=P, MATERIAL=STEEL\n.01\n" + steel_inp;
  const auto shell = [&](const std::string& type, const std::string& line) {
    return deck_of_inp(nodes + "*ELEMENT, TYPE=" + type + ", ELSET=P\n1, " +
                       line + "\n" + section)
        .shells.at(0);
  };
  EXPECT_EQ(shell("S3R", "1, 2, 3").grids.size(), 3U);
  EXPECT_EQ(shell("S4R", "1, 2, 3, 4").grids.size(), 4U);
  const Shell six = shell("S6", "1, 2, 3, 5, 6, 9");
  EXPECT_EQ(six.mids, (std::vector<int>{5, 6, 9}));
  const Shell eight = shell("S8R", "1, 2, 3, 4, 5, 6, 7, 8");
  EXPECT_EQ(eight.mids, (std::vector<int>{5, 6, 7, 8}));
}

}  // namespace
}  // namespace tapfit::structure
