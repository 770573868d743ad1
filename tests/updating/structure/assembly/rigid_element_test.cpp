// RBE2 and RBAR against closed forms and against models that say the same
// without them.
#include "acquisition/foundation/constants.hpp"
#include "acquisition/foundation/input_error.hpp"
#include "tests/support/matchers.hpp"
#include "tests/updating/support/deck_support.hpp"
#include "updating/structure/assembly/assemble.hpp"
#include "updating/structure/assembly/deck_modes.hpp"
#include "updating/structure/mesh/refine_mesh.hpp"

#include <cmath>
#include <fstream>
#include <map>

namespace tapfit::structure {
namespace {

// The same eigenproblem up to rounding of its products.
constexpr double same = 1e-9;

// 1 m along x without mass; GJ = 160 N m^2.
const std::string beam = R"(GRID,1,,0.,0.,0.
GRID,2,,1.,0.,0.
MAT1,1,2.+11,8.+10,,0.
PBAR,1,1,1.-4,3.-9,1.-9,2.-9
SPC1,1,123456,1
CBAR,1,1,1,2,0.,0.,1.
)";

void expect_same(const Eigenmodes& a, const Eigenmodes& b) {
  ASSERT_EQ(a.frequency_hz.size(), b.frequency_hz.size());
  for (Eigen::Index k = 0; k < a.frequency_hz.size(); ++k) {
    EXPECT_NEAR(a.frequency_hz(k) / b.frequency_hz(k), 1.0, same) << k;
  }
}

TEST(RigidElement, MassSwingsOnItsArm) {
  // Torsion: G J / (I11 + m y^2); the beam has no mass, all else is held.
  const Deck deck = deck_of(beam +
                            "GRID,3,,1.,.2,0.\nRBE2,2,2,123456,3\n"
                            "CONM2,3,3,,3.\n,.05\nSPC1,1,12356,2\n");
  const Eigen::VectorXd f = modes_of(deck, 2).frequency_hz;
  ASSERT_EQ(f.size(), 1);
  EXPECT_NEAR(f(0), std::sqrt(8e10 * 2e-9 / (0.05 + 3 * 0.04)) / two_pi, 1e-9);
}

TEST(RigidElement, ArmIsTheOffsetOfAMass) {
  const std::string inertia = "\n,.05,.01,.08,0.,.02,.1\n";
  const Deck arm = deck_of(beam +
                           "GRID,3,,1.3,.2,-.1\nRBE2,2,2,123456,3\n"
                           "CONM2,3,3,,3." +
                           inertia);
  const Deck offset = deck_of(beam + "CONM2,3,2,,3.,.3,.2,-.1" + inertia);
  const Deck bar = deck_of(beam +
                           "GRID,3,,1.3,.2,-.1\nRBAR,2,3,2,,123456\n"
                           "CONM2,3,3,,3." +
                           inertia);
  expect_same(modes_of(arm, 6), modes_of(offset, 6));
  expect_same(modes_of(bar, 6), modes_of(offset, 6));
  const double mass = total_mass(arm, assemble(arm));
  EXPECT_NEAR(mass, 3.0, 1e-12);
}

// Two plates side by side along x; the second one's grids have ids from 100 on.
Deck two_plates() {
  Deck deck = plate_deck({}, 3, 2);
  const Deck right = plate_deck({}, 3, 2);
  for (Grid grid : right.grids) {
    grid.id += 100;
    grid.position.x() += 1.0;
    deck.grids.push_back(grid);
  }
  for (Shell shell : right.shells) {
    shell.id += 100;
    for (int& grid : shell.grids) grid += 100;
    deck.shells.push_back(shell);
  }
  hold(deck, "123456", [](const Eigen::Vector3d& p) { return p.x() < 1e-9; });
  return deck;
}

// The grids at the seam: 10, 11, 12 on the left, 101, 102, 103 on the right.
Deck merged() {
  Deck deck = two_plates();
  std::erase_if(deck.grids,
                [](const Grid& g) { return g.id >= 101 && g.id <= 103; });
  for (Shell& shell : deck.shells) {
    for (int& grid : shell.grids) {
      if (grid >= 101 && grid <= 103) grid -= 91;
    }
  }
  return deck;
}

TEST(RigidElement, CoincidentGridsAreOne) {
  Deck tied = two_plates();
  for (int k = 0; k < 3; ++k) {
    tied.rigids.push_back({500 + k, 10 + k, {{101 + k, "123456"}}, {}});
  }
  expect_same(modes_of(tied, 8), modes_of(merged(), 8));
}

TEST(RigidElement, SpiderJoinsTwoPlates) {
  // A hub off the plates leads both edges; or the middle of the merged edge
  // leads its ends.
  Deck spider = two_plates();
  spider.grids.push_back({300, {1.0, 0.5, 0.2}});
  RigidElement e{500, 300, {}, {}};
  for (const int grid : {10, 11, 12, 101, 102, 103}) {
    e.dependents.push_back({grid, "123456"});
  }
  spider.rigids = {e};
  Deck edge = merged();
  edge.rigids = {{500, 11, {{10, "123456"}, {12, "123456"}}, {}}};
  expect_same(modes_of(spider, 8), modes_of(edge, 8));
}

TEST(RigidElement, WhatLeadsMayFollow) {
  const std::string grids =
      beam + "GRID,3,,1.,.2,0.\nGRID,4,,1.2,.2,.1\nCONM2,9,4,,2.\n,.01,,.02\n";
  const Deck chain = deck_of(grids + "RBE2,2,3,123456,4\nRBE2,3,2,123456,3\n");
  const Deck star = deck_of(grids + "RBE2,2,2,123456,3,4\n");
  expect_same(modes_of(chain, 5), modes_of(star, 5));
}

// A cantilever clamped by a grid beside it, and by the one that follows that:
// the same numbers as one that is held, with nothing left that follows.
TEST(RigidElement, OfAHeldGridIsAConstraint) {
  const std::string bar = R"(GRID,1,,0.,0.,0.
GRID,2,,.5,0.,0.
GRID,3,,1.,0.,0.
GRID,4,,-.2,.1,0.
GRID,5,,-.3,.1,0.
MAT1,1,2.+11,8.+10,,7800.
PBAR,1,1,1.-4,3.-9,1.-9,2.-9
CBAR,1,1,1,2,0.,0.,1.
CBAR,2,1,2,3,0.,0.,1.
)";
  const Deck held = deck_of(bar + "SPC1,1,123456,1,4,5\n");
  const Deck led =
      deck_of(bar + "SPC1,1,123456,5\nRBE2,8,4,123456,1\nRBAR,9,5,4,123456\n");
  const Eigenmodes modes = modes_of(led, 8);
  expect_same(modes, modes_of(held, 8));
  EXPECT_GT(modes.frequency_hz(0), 1.0);
  EXPECT_EQ(assemble(led).T.nonZeros(), 0);
}

TEST(RigidElement, FewComponentsMakeAHinge) {
  // Clamped at both ends, a pin in the middle: as bars with released ends.
  const std::string beams =
      "GRID,1,,0.,0.,0.\nGRID,2,,1.,0.,0.\nGRID,3,,1.,0.,0.\n"
      "GRID,4,,2.,0.,0.\nMAT1,1,2.+11,8.+10,,0.\n"
      "PBAR,1,1,1.-4,3.-9,1.-9,2.-9\nSPC1,1,123456,1,4\n"
      "CBAR,1,1,1,2,0.,0.,1.\nCONM2,9,2,,2.\n,.01,,.02,,,.03\n";
  const Deck hinge = deck_of(beams + "CBAR,2,1,3,4,0.,0.,1.\nRBE2,5,2,123,3\n");
  const Deck pin = deck_of(beams + "CBAR,2,1,2,4,0.,0.,1.\n,456\n");
  // Grid 3 turns without mass: three rotations more, none of them a mode.
  const Eigen::VectorXd f = modes_of(pin, 6).frequency_hz;
  const Eigen::VectorXd g = modes_of(hinge, 6).frequency_hz;
  for (Eigen::Index k = 0; k < 6; ++k) EXPECT_NEAR(g(k) / f(k), 1.0, same);
}

TEST(RigidElement, FreeBodyHasSixRigidMotions) {
  Deck deck = two_plates();
  deck.constraints.clear();
  deck.rigids = {{500, 11, {{101, "123456"}, {102, "123456"}}, {}}};
  const DeckModes modes = deck_modes(deck, assemble(deck), 8);
  EXPECT_TRUE(modes.warnings.empty());
  EXPECT_LT(modes.modes.frequency_hz(5), 1e-2);
  EXPECT_GT(modes.modes.frequency_hz(6), 1.0);
}

TEST(RigidElement, SplitMeshKeepsARigidEdgeRigid) {
  Deck deck = two_plates();
  deck.rigids = {{500,
                  11,
                  {{10, "123456"},
                   {12, "123456"},
                   {101, "123456"},
                   {102, "123456"},
                   {103, "123456"}},
                  {}}};
  const RefinedDeck fine = refine_mesh(deck);
  // Two new grids on each of the two edges of the seam.
  ASSERT_EQ(fine.deck.rigids[0].dependents.size(), 9U);
  const Eigenmodes modes = modes_of(fine.deck, 6);
  // The same rigid seam between plates of twice the elements, made directly.
  Deck direct = refine_mesh(two_plates()).deck;
  RigidElement seam{500, 11, {}, {}};
  for (const Grid& grid : direct.grids) {
    const bool at = std::abs(grid.position.x() - 1.0) < 1e-9;
    if (at && grid.id != 11) seam.dependents.push_back({grid.id, "123456"});
  }
  direct.rigids = {seam};
  expect_same(modes, modes_of(direct, 6));
}

std::string small(const std::vector<std::string>& fields, int width) {
  std::string line;
  for (std::size_t k = 0; k < fields.size(); ++k) {
    line += fmt::format("{:<{}}", fields[k], k == 0 ? 8 : width);
  }
  return line + "\n";
}

TEST(RigidElement, ThreeFieldFormatsReadAndWriteAlike) {
  const std::map<std::string, std::string> formats{
      {"free",
       "CORD2R,7,,0.,0.,0.,0.,0.,1.\n,.8,.6,0.\n"
       "RBE2,5,1,12345,2,3,4,6,7\n,8,THRU,10\nCDAMP2,4,2.5,1,3\n"},
      {"small",
       small({"CORD2R", "7", "", "0.", "0.", "0.", "0.", "0.", "1."}, 8) +
           small({"", ".8", ".6", "0."}, 8) +
           small({"RBE2", "5", "1", "12345", "2", "3", "4", "6", "7"}, 8) +
           small({"", "8", "THRU", "10"}, 8) +
           small({"CDAMP2", "4", "2.5", "1", "3"}, 8)},
      {"large",
       small({"CORD2R*", "7", "", "0.", "0."}, 16) +
           small({"*", "0.", "0.", "0.", "1."}, 16) +
           small({"*", ".8", ".6", "0."}, 16) +
           small({"RBE2*", "5", "1", "12345", "2"}, 16) +
           small({"*", "3", "4", "6", "7"}, 16) +
           small({"*", "8", "THRU", "10"}, 16) +
           small({"CDAMP2*", "4", "2.5", "1", "3"}, 16)}};
  std::string grids;
  for (const int id : {1, 2, 3, 4, 6, 7, 8, 10}) {
    grids += fmt::format("GRID,{},,{}.,0.,0.,7\n", id, id);
  }
  for (const auto& [name, cards] : formats) {
    const Deck first = deck_of(grids + cards);
    const std::filesystem::path copy = first.path.parent_path() / "copy.bdf";
    write_deck(first, {"CDAMP2,90,1.5,2,3"}, copy, {{}, true});
    const Deck second = read_deck(copy);
    for (const Deck& deck : {first, second}) {
      ASSERT_EQ(deck.rigids.size(), 1U) << name;
      EXPECT_EQ(deck.rigids[0].independent, 1) << name;
      std::vector<int> follow;
      for (const Dependent& d : deck.rigids[0].dependents) {
        follow.push_back(d.grid);
        EXPECT_EQ(d.components, "12345") << name;
      }
      EXPECT_EQ(follow, (std::vector<int>{2, 3, 4, 6, 7, 8, 10})) << name;
      EXPECT_NEAR(deck.grids[0].axes(1, 0), 0.6, 1e-15) << name;
      EXPECT_EQ(deck.scalars[0].damping, 2.5) << name;
      EXPECT_TRUE(deck.warnings.empty()) << name;
    }
    EXPECT_EQ(second.scalars.size(), 2U) << name;
    // Every line stays as it was written.
    EXPECT_TRUE(std::equal(
        first.cards.begin(), first.cards.end(), second.cards.begin()))
        << name;
  }
}

void expect_error(const std::string& cards,
                  const std::string& where,
                  const std::string& what) {
  try {
    // Lines 1 to 4; cards follow from line 5.
    const Deck deck = deck_of(
        "GRID,1,,0.,0.,0.\nGRID,2,,1.,0.,0.\nGRID,3,,2.,0.,0.\n"
        "GRID,4,,2.,1.,0.,,3\n" +
        cards);
    static_cast<void>(assemble(deck));
    ADD_FAILURE() << cards;
  } catch (const InputError& error) {
    EXPECT_THAT(error.where(), HasSubstr(where)) << cards << error.what();
    EXPECT_THAT(error.what(), HasSubstr(what)) << cards;
    EXPECT_FALSE(error.remedy().empty()) << cards;
  }
}

TEST(RigidElement, FaultsAreNamed) {
  expect_error(
      "RBE2,5,1,123456,9\n", "model.bdf:5 RBE2 5", "grid 9 does not exist");
  expect_error(
      "RBE2,5,9,123456,1\n", "model.bdf:5 RBE2 5", "grid 9 does not exist");
  expect_error("RBE2,5,1,,2\n", "model.bdf:5 RBE2 5", "names no component");
  expect_error("RBE2,5,1,123456\n", "model.bdf:5 RBE2 5", "no dependent grid");
  expect_error(
      "RBE2,5,1,123456,1\n", "model.bdf:5 RBE2 5", "names a grid twice");
  expect_error("RBE2,5,1,123456,2\nRBE2,6,3,3,2\n",
               "model.bdf:6 RBE2 6",
               "component 3 of grid 2 follows");
  expect_error("RBE2,5,1,123456,4\n",
               "model.bdf:5 RBE2 5",
               "component 3 of grid 4 follows grid 1 and is held");
  expect_error("RBE2,5,1,123456,2\nRBE2,6,2,123456,3\nRBE2,7,3,123456,1\n",
               "RBE2",
               "follows itself round a ring");
  expect_error("RBAR,5,1,2,1236,4\n", "model.bdf:5 RBAR 5", "six are needed");
  expect_error(
      "RBAR,5,1,2,123,123\n", "model.bdf:5 RBAR 5", "do not hold a rigid body");
}

}  // namespace
}  // namespace tapfit::structure
