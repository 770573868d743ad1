// *BOUNDARY, *MPC, sets and assemblies: which grids are held and joined.
#include "tests/updating/support/inp_support.hpp"

#include <map>
#include <set>

namespace tapfit::structure {
namespace {

std::map<int, std::set<char>> held(const Deck& deck) {
  std::map<int, std::set<char>> all;
  for (const Constraint& c : deck.constraints) {
    all[c.grid].insert(c.components.begin(), c.components.end());
  }
  return all;
}

std::set<char> digits(const std::string& text) {
  return {text.begin(), text.end()};
}

const std::string held_brick = one_brick() + brick_section;

TEST(InpConstraints, RangesNamesAndSets) {
  const auto all = held(deck_of_inp(
      held_brick +
      "*NSET, NSET=LOW, GENERATE\n1, 3\n*NSET, NSET=MORE\nLOW, 8\n"
      "*BOUNDARY\nMORE, 1, 2\n4, 3\n5, ENCASTRE\n6, PINNED\n7, XSYMM\n"));
  EXPECT_EQ(all.at(1), digits("12"));
  EXPECT_EQ(all.at(8), digits("12"));
  EXPECT_EQ(all.at(4), digits("3"));
  EXPECT_EQ(all.at(5), digits("123456"));
  EXPECT_EQ(all.at(6), digits("123"));
  EXPECT_EQ(all.at(7), digits("156"));
}

TEST(InpConstraints, StepsUpToTheModesCount) {
  const std::string steps =
      "*BOUNDARY\n1, 1, 3\n*STEP\n*STATIC\n*BOUNDARY\n2, 1\n*END STEP\n"
      "*STEP\n*FREQUENCY\n5\n*BOUNDARY\n3, 2\n*END STEP\n"
      "*STEP\n*STATIC\n*BOUNDARY\n4, 3\n*END STEP\n";
  const auto all = held(deck_of_inp(held_brick + steps));
  EXPECT_EQ(all.size(), 3U);
  EXPECT_EQ(all.at(3), digits("2"));
}

TEST(InpConstraints, NewTakesBackWhatWasHeld) {
  const auto all = held(deck_of_inp(
      held_brick +
      "*BOUNDARY\n1, 1, 3\n*STEP\n*FREQUENCY\n5\n*BOUNDARY, OP=NEW\n3, 2\n"
      "*BOUNDARY, OP=NEW\n4, 1\n*END STEP\n"));
  EXPECT_EQ(all.size(), 2U);
  EXPECT_TRUE(all.contains(3) && all.contains(4));
}

TEST(InpConstraints, GivenDisplacementIsSaidToBeZero) {
  EXPECT_TRUE(warns(deck_of_inp(held_brick + "*BOUNDARY\n1, 1, 1, 0.5\n"),
                    "is taken as zero"));
}

TEST(InpConstraints, MultiPointConstraintsByName) {
  const std::string more =
      "*NODE\n11, 0., 0., 0.\n12, 2., 0., 0.\n"
      "*ELEMENT, TYPE=MASS, ELSET=M\n11, 11\n12, 12\n*MASS, ELSET=M\n1.\n";
  const Deck beam = deck_of_inp(held_brick + more + "*MPC\nBEAM, 12, 2\n");
  ASSERT_EQ(beam.rigids.size(), 1U);
  EXPECT_EQ(beam.rigids[0].independent, 2);
  EXPECT_EQ(beam.rigids[0].dependents[0].grid, 12);
  const Deck pin = deck_of_inp(held_brick + more + "*MPC\nPIN, 11, 1\n");
  EXPECT_EQ(pin.relations.size(), 3U);
  EXPECT_EQ(pin.relations[2].grid, 11);
  EXPECT_EQ(pin.relations[2].terms[0].grid, 1);
  EXPECT_EQ(pin.relations[2].terms[0].factor, 1.0);
  const Deck tie = deck_of_inp(held_brick + more + "*MPC\nTIE, 11, 1\n");
  EXPECT_EQ(tie.relations.size(), 6U);
}

TEST(InpConstraints, EquationOfSetsIsOneForEachNode) {
  const Deck deck =
      deck_of_inp(held_brick +
                  "*NSET, NSET=A\n1, 2\n*NSET, NSET=B\n5, 6\n"
                  "*EQUATION\n3\nA, 1, 2., B, 1, -1.,\n8, 2, 4.\n");
  ASSERT_EQ(deck.relations.size(), 2U);
  EXPECT_EQ(deck.relations[1].grid, 2);
  ASSERT_EQ(deck.relations[1].terms.size(), 2U);
  EXPECT_EQ(deck.relations[1].terms[0].grid, 6);
  EXPECT_EQ(deck.relations[1].terms[0].factor, 0.5);
  EXPECT_EQ(deck.relations[1].terms[1].factor, -2.0);
}

TEST(InpConstraints, RigidBodyWithoutReferenceGetsItsMiddle) {
  const Deck deck = deck_of_inp(held_brick + "*RIGID BODY, ELSET=V\n");
  ASSERT_EQ(deck.rigids.size(), 1U);
  EXPECT_EQ(deck.rigids[0].dependents.size(), 8U);
  EXPECT_LT((deck.grid(deck.rigids[0].independent).position -
             Eigen::Vector3d(0.5, 0.5, 0.5))
                .norm(),
            1e-12);
}

// A reference point of the assembly has the id of a node of the part.
TEST(InpConstraints, OnePartWithOneInstance) {
  const Deck deck = deck_of_inp(
      "*PART, NAME=CUBE\n" + one_brick() +
      "*SOLID SECTION, ELSET=V, MATERIAL=STEEL\n*END PART\n"
      "*ASSEMBLY, NAME=A\n*INSTANCE, NAME=CUBE-1, PART=CUBE\n*END INSTANCE\n"
      "*NODE\n1, .5, .5, 2.\n*NSET, NSET=RP\n1,\n"
      "*NSET, NSET=LOW, INSTANCE=CUBE-1\n1, 2, 3, 4\n"
      "*NSET, NSET=TOP, INSTANCE=CUBE-1, GENERATE\n5, 8, 1\n"
      "*ELEMENT, TYPE=MASS, ELSET=M\n1, 1\n*MASS, ELSET=M\n3.\n"
      "*ELEMENT, TYPE=SPRINGA, ELSET=\"Springs/1\"\n2, 1, CUBE-1.7\n"
      "*SPRING, ELSET=\"Springs/1\"\n\n100.\n"
      "*SURFACE, NAME=S, TYPE=NODE\nTOP, 1.\n"
      "*COUPLING, CONSTRAINT NAME=C, REF NODE=RP, SURFACE=S\n*KINEMATIC\n"
      "*END ASSEMBLY\n" +
      steel_inp + "*BOUNDARY\nLOW, 1, 3\nCUBE-1.5, 1\n");
  EXPECT_EQ(deck.grids.size(), 9U);
  ASSERT_EQ(deck.masses.size(), 1U);
  ASSERT_EQ(deck.rigids.size(), 1U);
  EXPECT_EQ(deck.rigids[0].independent, deck.masses[0].grid);
  EXPECT_EQ(deck.grid(deck.masses[0].grid).position.z(), 2.0);
  ASSERT_EQ(deck.scalars.size(), 1U);
  EXPECT_EQ(deck.scalars[0].grids, (std::array<int, 2>{9, 7}));
  const auto all = held(deck);
  EXPECT_EQ(all.at(4), digits("123"));
  EXPECT_EQ(all.at(5), digits("1"));
}

TEST(InpConstraints, MorePartsOrMovedOnesAreRefused) {
  const std::string part = "*PART, NAME=P\n" + one_brick() + "*END PART\n";
  EXPECT_THAT([&] { deck_of_inp(part + part + brick_section); },
              Refuses("more than one of these"));
  EXPECT_THAT(
      [&] {
        deck_of_inp(part +
                    "*ASSEMBLY, NAME=A\n*INSTANCE, NAME=I, PART=P\n"
                    "0., 0., 1.\n*END INSTANCE\n*END ASSEMBLY\n" +
                    brick_section);
      },
      Refuses("the instance is moved"));
}

}  // namespace
}  // namespace tapfit::structure
