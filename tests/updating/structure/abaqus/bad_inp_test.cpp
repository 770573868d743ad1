// Decks with a fault: the error names what, the line of the .inp, the remedy.
// And what is not read: refused by its keyword, left out where it is named.
#include "acquisition/foundation/input_error.hpp"
#include "tests/updating/support/inp_support.hpp"
#include "updating/structure/readers/unsupported_cards.hpp"

namespace tapfit::structure {
namespace {

InputError error_of(const std::string& text,
                    const std::vector<std::string>& ignored = {}) {
  try {
    static_cast<void>(deck_of_inp(text, ignored));
  } catch (const InputError& error) {
    return error;
  }
  return {"no error", "", ""};
}

void expect_error(const std::string& text,
                  const std::string& where,
                  const std::string& what) {
  const InputError error = error_of(text);
  EXPECT_THAT(error.where(), HasSubstr(where)) << text << error.what();
  EXPECT_THAT(error.fault(), HasSubstr(what)) << text;
  EXPECT_FALSE(error.remedy().empty()) << text;
}

// Lines 1 to 9 nodes, 10 and 11 the element, 12 to 17 section and material.
const std::string whole_brick = one_brick() + brick_section;

TEST(BadInp, IdsAreTakenOrNotDefined) {
  expect_error(whole_brick + "*NODE\n3, 0., 0., 0.\n",
               "plate.inp:19",
               "node 3 is defined already in plate.inp:4");
  expect_error(whole_brick + "*ELEMENT, TYPE=MASS\n1, 1\n",
               "plate.inp:19",
               "element 1 is defined already");
  expect_error(whole_brick + "*ELEMENT, TYPE=MASS\n2, 99\n",
               "plate.inp:19",
               "node 99 is not defined");
  expect_error(whole_brick + "*BOUNDARY\n99, 1\n", "plate.inp:19", "node 99");
  expect_error(
      whole_brick + "*NSET, NSET=A\n1, 99\n", "plate.inp:19", "node 99");
  expect_error(
      whole_brick + "*ELSET, ELSET=A\n99\n", "plate.inp:19", "element 99");
}

TEST(BadInp, NamesAreNotDefined) {
  expect_error(whole_brick + "*BOUNDARY\nFIX, 1\n",
               "plate.inp:19",
               "the node set FIX is not defined");
  expect_error(
      one_brick() + "*SOLID SECTION, ELSET=W, MATERIAL=STEEL\n" + steel_inp,
      "plate.inp:12",
      "the element set W is not defined");
  expect_error(one_brick() + "*SOLID SECTION, ELSET=V, MATERIAL=GOLD\n",
               "plate.inp:12",
               "the material GOLD is not defined");
  expect_error(
      one_brick() + "*SOLID SECTION, ELSET=V, MATERIAL=M\n*MATERIAL, NAME=M\n",
      "plate.inp:13",
      "the material M has no *ELASTIC");
  expect_error(whole_brick + "*TIE, NAME=T\nA, B\n",
               "plate.inp:19",
               "the surface A is not defined");
  expect_error(whole_brick + "*COUPLING, REF NODE=1, SURFACE=A\n*KINEMATIC\n",
               "plate.inp:18",
               "the surface A is not defined");
  expect_error(one_shell() +
                   "*SHELL SECTION, ELSET=P, MATERIAL=STEEL, ORIENTATION=O\n"
                   ".01\n" +
                   steel_inp,
               "plate.inp:8",
               "the orientation O is not defined");
}

// A set that names itself names what is not there yet.
TEST(BadInp, SetsNameEachOther) {
  expect_error(whole_brick + "*NSET, NSET=A\nB\n*NSET, NSET=B\nA\n",
               "plate.inp:19",
               "the node set B is not defined");
}

TEST(BadInp, ElementHasNoSection) {
  expect_error(one_brick() + steel_inp,
               "plate.inp:11",
               "element 1 (C3D8) has no section");
  expect_error(whole_brick + "*ELEMENT, TYPE=SPRING1, ELSET=K\n2, 1\n",
               "plate.inp:19",
               "element 2 (SPRING1) has no section");
}

TEST(BadInp, ElementHasTooFewNodes) {
  expect_error(
      one_brick().substr(0, one_brick().size() - 4) + "\n" + brick_section,
      "plate.inp:11",
      "element 1 has 7 nodes, C3D8 has 8");
}

TEST(BadInp, NumbersAreNone) {
  expect_error("*NODE\n1, 0., x1, 0.\n", "plate.inp:2", "a number is needed");
  expect_error("*NODE\n1, 0., 1e400, 0.\n", "plate.inp:2", "a number");
  expect_error("*NODE\nA, 0., 0., 0.\n", "plate.inp:2", "an integer is needed");
  expect_error("*NODE\n-1, 0., 0., 0.\n", "plate.inp:2", "not above zero");
  expect_error("*NODE\n2147483647, 0.\n", "plate.inp:2", "too large");
  expect_error(
      whole_brick + "*NSET, NSET=A, GENERATE\n-2000000000, 2000000000\n",
      "plate.inp:19",
      "names nothing");
  expect_error("*NODE\n1, 0., 1e38, 0.\n" + brick_section, "plate.inp", "");
  expect_error(one_shell() + "*SHELL SECTION, ELSET=P, MATERIAL=STEEL\n-.01\n" +
                   steel_inp,
               "plate.inp:9",
               "the thickness is -0.01");
  expect_error(one_brick() +
                   "*SOLID SECTION, ELSET=V, MATERIAL=M\n*MATERIAL, NAME=M\n"
                   "*ELASTIC\n-1., .3\n",
               "plate.inp:13",
               "the moduli of M are those of no elastic material");
}

TEST(BadInp, FarCoordinateIsRefusedAtItsLine) {
  std::string text = whole_brick;
  text.replace(text.find("1., 1., 1."), 2, "1e38");
  const InputError error = error_of(text);
  EXPECT_THAT(error.where(), HasSubstr("plate.inp:8 GRID 7"));
  EXPECT_THAT(error.fault(), HasSubstr("farther away"));
}

TEST(BadInp, DataLinesAreMissing) {
  expect_error(
      one_shell() + "*SHELL SECTION, ELSET=P, MATERIAL=STEEL\n" + steel_inp,
      "plate.inp:8",
      "data line 1 (thickness) is missing");
  expect_error(
      one_shell() + "*SHELL SECTION, MATERIAL=STEEL\n.01\n" + steel_inp,
      "plate.inp:8",
      "it names no ELSET");
  expect_error(
      whole_brick + "*EQUATION\n2\n1, 1, 1.\n", "plate.inp:18", "missing");
  expect_error("*HEADING\nnothing else\n", "plate.inp:1", "has no *NODE");
}

TEST(BadInp, OptionsThatAreNotRead) {
  expect_error(one_shell() + "*SHELL GENERAL SECTION, ELSET=P\n1., 2.\n",
               "plate.inp:8",
               "stiffness matrix is not read");
  expect_error(whole_brick +
                   "*ELEMENT, TYPE=SPRINGA, ELSET=K\n2, 1, 7\n"
                   "*SPRING, ELSET=K, NONLINEAR\n\n1., 2.\n",
               "plate.inp:20",
               "the option NONLINEAR is not read");
  expect_error(whole_brick +
                   "*ELEMENT, TYPE=MASS, ELSET=K\n2, 7\n"
                   "*MASS, ELSET=K, TYPE=ANISOTROPIC\n1., 2., 3.\n",
               "plate.inp:20",
               "the option TYPE is not read");
  expect_error(one_brick() + "*SOLID SECTION, ELSET=V, COMPOSITE, MATERIAL=M\n",
               "plate.inp:12",
               "layered solids");
}

TEST(BadInp, FilesThatAreNoDecksAreNotQuoted) {
  // Empty, binary: neither bulk data nor keywords.
  expect_error("", "", "no GRID");
  expect_error(std::string("\x7f"
                           "ELF\x01\x02\nsecret of it\n"),
               "",
               "is no");
  // Keyword-like beginnings of other files.
  const InputError error = error_of(
      "*Secret notes about somebody\nthis is prose, and more of it\n"
      "nobody shall read this\nnor that, whatever it is\n");
  EXPECT_THAT(error.fault(), HasSubstr("is no Abaqus or CalculiX deck"));
  EXPECT_THAT(error.what(), Not(HasSubstr("somebody")));
}

TEST(BadInp, RefusedUnlessNamed) {
  const std::string text = whole_brick +
                           "*CONTACT PAIR, INTERACTION=I\nA, B\n"
                           "*ELEMENT, TYPE=CPE4, ELSET=Q\n7, 1, 2, 3, 4\n";
  const InputError error = error_of(text);
  EXPECT_EQ(error.where(), "plate.inp:18");
  EXPECT_THAT(error.fault(), HasSubstr("CPE4 (line 21"));
  EXPECT_THAT(error.fault(), HasSubstr("CONTACT PAIR (line 18, 1 in all)"));
  EXPECT_THAT(error.remedy(), HasSubstr("--ignore-card"));
  EXPECT_THAT(error_of(text, {"CPE4"}).remedy(),
              HasSubstr("--ignore-card CONTACTPAIR"));
  const Deck deck = deck_of_inp(text, {"contact pair", "CPE4"});
  EXPECT_TRUE(warns(deck, "CONTACT PAIR (line 18"));
  EXPECT_EQ(deck.element_count(), 1U);
}

TEST(BadInp, MultiPointConstraintsThatAreNotRead) {
  const std::string text = whole_brick + "*MPC\nSTRAIGHT, 1, 2, 3\n";
  EXPECT_THAT(error_of(text).fault(), HasSubstr("MPC STRAIGHT (line 19"));
  EXPECT_EQ(error_of(text, {"MPC STRAIGHT"}).fault(), "no error");
}

TEST(BadInp, SectorsAreRefused) {
  EXPECT_THAT(
      error_of(whole_brick + "*TIE, CYCLIC SYMMETRY, NAME=T\nA, B\n").fault(),
      HasSubstr("TIE (line 18"));
}

TEST(BadInp, OtherKeywordsAreListedOnce) {
  const Deck deck = deck_of_inp(
      whole_brick +
      "*AMPLITUDE, NAME=A\n0., 1.\n*WHATEVER\n1, 2\n*STEP\n*STATIC\n"
      "*CLOAD\n1, 1, 5.\n*NODE PRINT\nU\n*NODE PRINT\nU\n*END STEP\n");
  EXPECT_TRUE(warns(deck,
                    "keywords that are not read, of loads, output or the like: "
                    "AMPLITUDE, CLOAD, NODE PRINT, WHATEVER"));
}

TEST(BadInp, ElementHasTwoSections) {
  expect_error(whole_brick + "*SOLID SECTION, ELSET=V, MATERIAL=STEEL\n",
               "plate.inp:18",
               "element 1 has a section already");
}

TEST(BadInp, ModelDataInAStepIsNotPassedOver) {
  const std::string text = whole_brick +
                           "*STEP\n*FREQUENCY\n5\n"
                           "*EQUATION\n2\n7, 1, 1., 6, 1, -1.\n*END STEP\n";
  EXPECT_THAT(error_of(text).fault(),
              HasSubstr("EQUATION (line 21, 1 in all) is not read: it stands "
                        "in a step"));
  EXPECT_EQ(error_of(text, {"EQUATION"}).fault(), "no error");
}

TEST(BadInp, StepWithoutEndIsSaid) {
  EXPECT_TRUE(warns(deck_of_inp(whole_brick + "*STEP\n*FREQUENCY\n5\n"),
                    "plate.inp:18: the step has no *END STEP"));
}

TEST(BadInp, RangesOfDegreesOfFreedom) {
  expect_error(whole_brick + "*BOUNDARY\n1, 0, 3\n",
               "plate.inp:19",
               "0 to 3 are no degrees of freedom");
  expect_error(whole_brick + "*BOUNDARY\n1, 1, 100\n",
               "plate.inp:19",
               "1 to 100 are no degrees of freedom");
}

// Names come to the terminal in warnings.
TEST(BadInp, ControlCharactersOfNamesAreNotSaid) {
  const Deck deck = deck_of_inp(
      one_brick() +
      "*SOLID SECTION, ELSET=V, MATERIAL=\x1b[31mX\n*MATERIAL, NAME=\x1b[31mX\n"
      "*ELASTIC\n2.1e11, .3\n");
  EXPECT_TRUE(warns(deck, "MAT1 1 is ?[31MX"));
}

// Both programs take a number for an id; a set of that name would be another.
TEST(BadInp, NumbersAsNamesOfSets) {
  expect_error(whole_brick + "*NSET, NSET=3\n1, 2\n*BOUNDARY\n3, 1\n",
               "plate.inp:21",
               "3 is a set and the id of one node");
  EXPECT_EQ(error_of(whole_brick + "*NSET, NSET=30\n1, 2\n*BOUNDARY\n30, 1\n")
                .fault(),
            "no error");
}

TEST(BadInp, BlankNodeIsNotPassedOver) {
  expect_error(
      "*NODE\n1\n2\n3\n4\n5\n*ELEMENT, TYPE=S4, ELSET=P\n1, 1, 2, , 4, 5\n",
      "plate.inp:8",
      "field 4 (node)");
}

TEST(BadInp, SystemsThatAreNotRead) {
  expect_error("*NODE, SYSTEM=S\n1, 1., 2., 3.\n",
               "plate.inp:1",
               "SYSTEM is neither R nor C");
}

// The stiffness of a load before the modes is not known; a step that loads
// nothing, or that modes do not stand on, changes none.
TEST(BadInp, LoadedStatesAreRefused) {
  const auto steps = [](const std::string& first,
                        const std::string& load,
                        const std::string& second) {
    return "*STEP" + first + "\n*STATIC\n" + load + "*END STEP\n*STEP" +
           second + "\n*FREQUENCY\n5\n*END STEP\n";
  };
  const std::string load = "*CLOAD\n7, 1, 5.\n";
  for (const std::string& text :
       {steps("", load, ", PERTURBATION"), steps(", NLGEOM", load, "")}) {
    expect_error(whole_brick + text, "plate.inp", "stiffness of the load");
    EXPECT_TRUE(
        warns(deck_of_inp(whole_brick + text, {"STATIC"}), "STATIC (line"));
  }
  for (const std::string& text :
       {steps(", NLGEOM", "", ", PERTURBATION"), steps("", load, "")}) {
    EXPECT_FALSE(warns(deck_of_inp(whole_brick + text), "STATIC"));
  }
}

// What is missing may come from what is not read.
TEST(BadInp, ErrorsNameWhatIsNotRead) {
  const InputError error =
      error_of(one_brick() +
               "*SOLID SECTION, ELSET=V, MATERIAL=R\n*MATERIAL, NAME=R\n"
               "*HYPERELASTIC\n1., 2.\n");
  EXPECT_THAT(error.fault(), HasSubstr("has no *ELASTIC"));
  EXPECT_THAT(error.remedy(), HasSubstr("HYPERELASTIC (line 14"));
}

}  // namespace
}  // namespace tapfit::structure
