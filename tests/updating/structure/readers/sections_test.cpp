// Sections of PBARL and PBEAML: area by hand, moments by summing small squares;
// beams whose section changes.
#include "acquisition/foundation/input_error.hpp"
#include "tests/support/matchers.hpp"
#include "tests/updating/support/deck_support.hpp"
#include "updating/structure/readers/deck_builder.hpp"

#include <cmath>
#include <functional>

namespace tapfit::structure {
namespace {

// Whether a place (y, z) is inside of a section.
using Inside = std::function<bool(double, double)>;

bool within(double value, double low, double high) {
  return value > low && value < high;
}

struct Summed {
  double area = 0.0, I1 = 0.0, I2 = 0.0, I12 = 0.0;
};

// Over a square of side 2 with 1000 x 1000 points.
Summed sum_up(const Inside& inside) {
  constexpr int points = 1000;
  const double h = 2.0 / points;
  double A = 0, Sy = 0, Sz = 0, yy = 0, zz = 0, yz = 0;
  for (int i = 0; i < points; ++i) {
    for (int j = 0; j < points; ++j) {
      const double y = -1.0 + (i + 0.5) * h;
      const double z = -1.0 + (j + 0.5) * h;
      if (!inside(y, z)) continue;
      A += h * h;
      Sy += y * h * h;
      Sz += z * h * h;
      yy += y * y * h * h;
      zz += z * z * h * h;
      yz += y * z * h * h;
    }
  }
  return {A, yy - Sy * Sy / A, zz - Sz * Sz / A, yz - Sy * Sz / A};
}

void expect_section(const std::string& type,
                    const std::vector<double>& d,
                    const Inside& inside) {
  const std::optional<BarProperty> p = section_of(type, d);
  ASSERT_TRUE(p) << type;
  const Summed s = sum_up(inside);
  // The pixels' share of an edge.
  EXPECT_NEAR(p->area, s.area, 0.01 * s.area) << type;
  EXPECT_NEAR(p->I1, s.I1, 0.02 * s.I1) << type;
  EXPECT_NEAR(p->I2, s.I2, 0.02 * s.I2) << type;
  EXPECT_NEAR(p->I12, s.I12, 0.02 * (s.I1 + s.I2)) << type;
  EXPECT_GT(p->J, 0.0) << type;
}

TEST(Sections, MomentsAreThoseOfTheirOutline) {
  const auto abs = [](double x) { return std::abs(x); };
  expect_section("I1", {0.6, 0.1, 0.8, 1.0}, [&](double y, double z) {
    return (abs(y) < 0.4 && abs(z) < 0.05) ||
           (within(abs(y), 0.4, 0.5) && abs(z) < 0.35);
  });
  expect_section("T2", {0.8, 1.0, 0.2, 0.1}, [&](double y, double z) {
    return (within(y, 0, 0.2) && abs(z) < 0.4) ||
           (within(y, 0.2, 1.0) && abs(z) < 0.05);
  });
  expect_section("T1", {0.8, 0.6, 0.2, 0.1}, [&](double y, double z) {
    return (abs(y) < 0.4 && within(z, 0, 0.2)) ||
           (abs(y) < 0.05 && within(z, 0.2, 0.8));
  });
  expect_section("CHAN1", {0.5, 0.1, 0.8, 1.0}, [&](double y, double z) {
    return (abs(y) < 0.5 && within(z, 0, 0.1)) ||
           (within(abs(y), 0.4, 0.5) && within(z, 0.1, 0.6));
  });
  expect_section("CHAN2", {0.1, 0.2, 0.9, 0.8}, [&](double y, double z) {
    return (within(y, 0, 0.2) && abs(z) < 0.4) ||
           (within(y, 0.2, 0.9) && within(abs(z), 0.3, 0.4));
  });
  expect_section("L", {0.7, 0.9, 0.1, 0.2}, [](double y, double z) {
    return (within(y, 0, 0.1) && within(z, -0.7, 0)) ||
           (within(y, 0, 0.9) && within(z, -0.2, 0));
  });
  expect_section("Z", {0.4, 0.1, 0.6, 0.8}, [&](double y, double z) {
    return (abs(y) < 0.3 && abs(z) < 0.05) ||
           (within(y, 0.3, 0.4) && within(z, -0.45, 0.05)) ||
           (within(y, -0.4, -0.3) && within(z, -0.05, 0.45));
  });
  expect_section("CROSS", {0.6, 0.1, 0.9, 0.2}, [&](double y, double z) {
    return (abs(y) < 0.45 && abs(z) < 0.05) || (abs(y) < 0.1 && abs(z) < 0.35);
  });
  expect_section("H", {0.6, 0.2, 0.9, 0.1}, [&](double y, double z) {
    return (abs(y) < 0.05 && abs(z) < 0.3) ||
           (abs(y) < 0.45 && within(abs(z), 0.3, 0.4));
  });
  expect_section("HAT", {0.6, 0.1, 0.5, 0.3}, [&](double y, double z) {
    return (within(y, 0.5, 0.6) && abs(z) < 0.25) ||
           (within(y, 0.1, 0.5) && within(abs(z), 0.15, 0.25)) ||
           (within(y, 0, 0.1) && within(abs(z), 0.15, 0.55));
  });
  expect_section(
      "BOX1", {0.8, 1.0, 0.1, 0.2, 0.1, 0.2}, [](double y, double z) {
        return within(y, 0, 1) && within(z, 0, 0.8) &&
               !(within(y, 0.2, 0.9) && within(z, 0.1, 0.6));
      });
  // Its plate 0.1 thick and 1.1 wide, the hat 0.2 thick.
  expect_section("HAT1", {1.1, 0.8, 0.7, 0.2, 0.1}, [&](double y, double z) {
    return (within(y, 0, 0.1) && abs(z) < 0.55) ||
           (within(y, 0.6, 0.8) && abs(z) < 0.35) ||
           (within(y, 0.1, 0.6) && within(abs(z), 0.15, 0.35)) ||
           (within(y, 0.1, 0.3) && within(abs(z), 0.35, 0.55));
  });
  // Walls upright 0.1, 0.2, 0.3 thick, lying left 0.1 and 0.2, right 0.2 and
  // 0.3; the middle one stands about 0.6 from the left, at z = -0.7.
  expect_section("DBOX",
                 {1.4, 1.0, 0.6, 0.1, 0.2, 0.3, 0.1, 0.2, 0.2, 0.3},
                 [](double y, double z) {
                   return within(y, 0, 1) && within(z, -0.7, 0.7) &&
                          !(within(y, 0.2, 0.9) && within(z, -0.6, -0.2)) &&
                          !(within(y, 0.3, 0.8) && within(z, 0.0, 0.4));
                 });
  expect_section("HEXA", {0.2, 0.9, 0.6}, [&](double y, double z) {
    return abs(y) < 0.3 && abs(z) < 0.45 - 0.2 * abs(y) / 0.3;
  });
}

// Of alike cells the wall between them has no shear flow: Bredt's J of the box
// around both. A hat without feet on a plate is a box.
TEST(Sections, ClosedCellsTwistByBredt) {
  const std::vector<double> two(7, 0.01);
  std::vector<double> dimensions{0.6, 0.3, 0.3};
  dimensions.insert(dimensions.end(), two.begin(), two.end());
  const auto both = section_of("DBOX", dimensions);
  const auto around = section_of("BOX1", {0.6, 0.3, 0.01, 0.01, 0.01, 0.01});
  ASSERT_TRUE(both && around);
  EXPECT_NEAR(both->J, around->J, 1e-12 * around->J);
  const auto hat = section_of("HAT1", {0.4, 0.3, 0.4, 0.01, 0.02});
  const auto box = section_of("BOX1", {0.4, 0.3, 0.01, 0.02, 0.01, 0.01});
  ASSERT_TRUE(hat && box);
  EXPECT_NEAR(hat->J, box->J, 1e-12 * box->J);
  EXPECT_NEAR(hat->area, box->area, 1e-12);
}

// DIM5 to DIM8 are DIM4 where they are blank, DIM9 and DIM10 are DIM6.
TEST(Sections, WallsOfADoubleBoxHaveDefaults) {
  const std::string deck =
      "GRID,1,,0.,0.,0.\nGRID,2,,1.,0.,0.\nMAT1,1,7.+10,,.3,2700.\n"
      "CBAR,6,2,1,2,0.,0.,1.\nPBARL,2,1,,DBOX\n";
  const Deck blank = deck_of(deck + ",.6,.3,.3,.01,,.02\n");
  const Deck full = deck_of(deck + ",.6,.3,.3,.01,.01,.02,.01,.01\n,.02,.02\n");
  EXPECT_DOUBLE_EQ(blank.bar_properties.at(2).J, full.bar_properties.at(2).J);
  EXPECT_DOUBLE_EQ(blank.bar_properties.at(2).area,
                   full.bar_properties.at(2).area);
}

const std::string beam =
    "GRID,1,,0.,0.,0.\nGRID,2,,1.,0.,0.\nMAT1,1,7.+10,,.3,2700.\n"
    "CBEAM,6,2,1,2,0.,0.,1.\n";

TEST(Sections, ChangingBeamHasItsMean) {
  const Deck deck = deck_of(beam +
                            "PBEAM,2,1,1.-4,1.-8,2.-8,,3.-8\n"
                            ",0.,0.\n"
                            ",NO,1.,3.-4,2.-8,4.-8,,5.-8\n"
                            ",0.,0.\n");
  const BarProperty& p = deck.bar_properties.at(2);
  EXPECT_DOUBLE_EQ(p.area, 2e-4);
  EXPECT_DOUBLE_EQ(p.I1, 1.5e-8);
  EXPECT_DOUBLE_EQ(p.I2, 3e-8);
  EXPECT_DOUBLE_EQ(p.J, 4e-8);
  ASSERT_EQ(deck.warnings.size(), 1U);
  EXPECT_THAT(deck.warnings[0], HasSubstr("PBEAM 2: the section changes"));
}

TEST(Sections, DimensionsOfABeamAlongIt) {
  const Deck constant = deck_of(beam + "PBEAML,2,1,,BAR\n,.02,.03,1.5\n");
  EXPECT_DOUBLE_EQ(constant.bar_properties.at(2).area, 6e-4);
  EXPECT_DOUBLE_EQ(constant.bar_properties.at(2).nonstructural, 1.5);
  EXPECT_TRUE(constant.warnings.empty());
  const Deck changing =
      deck_of(beam + "PBEAML,2,1,,BAR\n,.02,.03,0.,NO,1.,.02,.01,0.\n");
  EXPECT_DOUBLE_EQ(changing.bar_properties.at(2).area, 4e-4);
  EXPECT_EQ(changing.warnings.size(), 1U);
}

// Along the line of its grids a beam whose neutral axis lies off them bends
// like one on offsets.
TEST(Sections, NeutralAxisIsAnOffset) {
  const std::string section = "PBEAM,2,1,1.-4,1.-8,2.-8,,3.-8\n,,,,,,,,\n";
  const Deck by_axis = deck_of(beam + section + ",0.,0.,,,,,,\n,,,,,.05,.02\n");
  const Deck by_offset = deck_of(
      "GRID,1,,0.,0.,0.\nGRID,2,,1.,0.,0.\nMAT1,1,7.+10,,.3,2700.\n"
      "CBEAM,6,2,1,2,0.,0.,1.\n,,,0.,-.02,.05,0.,-.02,.05\n" +
      section + ",0.,0.\n");
  const System a = assemble(by_axis);
  const System b = assemble(by_offset);
  // Twist is about the shear centre, which the offset moves, too: held.
  std::vector<int> kept;
  for (int i = 0; i < 12; ++i) {
    if (i != 3 && i != 9) kept.push_back(i);
  }
  const Eigen::MatrixXd Ka = Eigen::MatrixXd(a.K)(kept, kept);
  const Eigen::MatrixXd Kb = Eigen::MatrixXd(b.K)(kept, kept);
  EXPECT_LT((Ka - Kb).norm(), 1e-12 * Kb.norm());
}

}  // namespace
}  // namespace tapfit::structure
