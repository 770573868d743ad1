// Decks with a fault: the error or warning names the card, its line, the
// remedy.
#include "acquisition/foundation/input_error.hpp"
#include "tests/support/matchers.hpp"
#include "tests/updating/support/deck_support.hpp"
#include "updating/structure/assembly/assemble.hpp"
#include "updating/structure/assembly/deck_modes.hpp"

namespace tapfit::structure {
namespace {

// Lines 1 to 6; elements follow from line 7.
const std::string grid_cards_text = R"(GRID,1,,0.,0.,0.
GRID,2,,1.,0.,0.
GRID,3,,1.,1.,0.
GRID,4,,0.,1.,0.
PSHELL,1,1,0.01,1,,1
MAT1,1,7.+10,,.3,2700.
)";

InputError error_of(const std::string& text) {
  try {
    const Deck deck = deck_of(text);
    static_cast<void>(deck_modes(deck, assemble(deck), 10));
  } catch (const InputError& error) {
    return error;
  }
  return {"no error", "", ""};
}

void expect_error(const std::string& cards,
                  const std::string& where,
                  const std::string& what) {
  const InputError error = error_of(grid_cards_text + cards);
  EXPECT_THAT(error.where(), HasSubstr(where)) << cards << error.what();
  EXPECT_THAT(error.what(), HasSubstr(what)) << cards;
  EXPECT_FALSE(error.remedy().empty()) << cards;
}

TEST(BadDeck, PropertyOrMaterialIsMissing) {
  expect_error("CQUAD4,5,9,1,2,3,4\n",
               "model.bdf:7 CQUAD4 5",
               "PSHELL 9 does not exist");
  expect_error("CROD,5,9,1,2\n", "model.bdf:7 CROD 5", "PROD 9");
  expect_error("CBAR,5,9,1,2,0.,0.,1.\n", "model.bdf:7 CBAR 5", "PBAR");
  expect_error("CBUSH,5,9,1,2,,,,0\n", "model.bdf:7 CBUSH 5", "PBUSH 9");
  expect_error("PSHELL,2,8,.01\n", "model.bdf:7 PSHELL 2", "material 8");
  expect_error("PBAR,2,8,1.-4\n", "model.bdf:7 PBAR 2", "material 8");
  expect_error("CONROD,5,1,2,8,1.-4\n", "model.bdf:7 CONROD 5", "material 8");
}

TEST(BadDeck, BarOrRodIsOrthotropic) {
  const std::string wood = "MAT8,8,1.+10,1.+9,.3,1.+9\n";
  const std::string what = "material 8 is a MAT8";
  expect_error(wood + "PBAR,2,8,1.-4\n", "model.bdf:8 PBAR 2", what);
  expect_error(wood + "PROD,2,8,1.-4\n", "model.bdf:8 PROD 2", what);
  expect_error(wood + "CONROD,5,1,2,8,1.-4\n", "model.bdf:8 CONROD 5", what);
}

TEST(BadDeck, BarIsLetGoOfByItsPins) {
  const std::string bar =
      "PBAR,2,1,1.-4,1.-9,1.-9,1.-9\nCBAR,5,2,1,2,0.,0.,1.\n";
  for (const char* pins : {"1,1", "2,2", "356,35"}) {
    expect_error(bar + "," + pins + "\n", "model.bdf:8 CBAR 5", "let go of");
  }
  // What one end lets go of, the other holds.
  for (const char* pins : {"56,56", "123", ",1", "1,2"}) {
    const Deck deck = deck_of(
        "GRID,1,,0.,0.,0.\nGRID,2,,1.,0.,0.\n"
        "MAT1,1,7.+10,,.3,2700.\n" +
        bar + "," + pins + "\n");
    EXPECT_NEAR(total_mass(deck, assemble(deck)), 0.27, 1e-9) << pins;
  }
}

TEST(BadDeck, FieldIsQuotedInPart) {
  const InputError error = error_of("GRID,1,," + std::string(500, 'x') + "\n");
  EXPECT_THAT(error.what(), HasSubstr("\"xxxx"));
  EXPECT_LT(std::string(error.what()).size(), 250U);
}

TEST(BadDeck, ThicknessIsZero) {
  expect_error("PSHELL,2,1,0.\n", "model.bdf:7 PSHELL 2", "thickness is 0");
}

TEST(BadDeck, SectionIsNegative) {
  for (const char* card : {"PBAR,2,1,-1.-4\n",
                           "PBAR,2,1,1.-4,-1.-9,1.-9\n",
                           "PBAR,2,1,1.-4,1.-9,-1.-9\n",
                           "PBAR,2,1,1.-4,1.-9,1.-9,-1.-9\n",
                           "PBEAM,2,1,1.-4,-1.-9,1.-9\n",
                           "PROD,2,1,-1.-4\n",
                           "CONROD,2,1,2,1,-1.-4\n"}) {
    expect_error(card, "model.bdf:7 ", "below zero");
  }
}

TEST(BadDeck, DefinitionIsRepeated) {
  for (const std::string card : {"MAT1,7,7.+10,,.3\n",
                                 "MAT8,7,7.+10,7.+10,.3,2.+10\n",
                                 "PSHELL,7,1,.01\n",
                                 "PBAR,7,1,1.-4\n",
                                 "PBEAM,7,1,1.-4,1.-9,1.-9\n",
                                 "PROD,7,1,1.-4\n",
                                 "PELAS,7,10.\n",
                                 "PDAMP,7,10.\n",
                                 "PBUSH,7,K,10.\n",
                                 "CORD2R,7,,0.,0.,0.,0.,0.,1.\n,1.\n"}) {
    const InputError error = error_of(grid_cards_text + card + card);
    const int second = std::count(card.begin(), card.end(), '\n') == 1 ? 8 : 9;
    EXPECT_THAT(error.where(), HasSubstr(fmt::format("model.bdf:{} ", second)));
    EXPECT_THAT(error.what(), HasSubstr("is defined already by model.bdf:7"))
        << card;
  }
  expect_error("MAT8,8,9.+8,1.1+10,.35,7.5+8\n", "MAT8 8", "E2 exchanged?");
  expect_error("MAT8,8,9.+8,1.1+10,3.5,7.5+8\n", "MAT8 8", "above zero");
  // MAT1 and MAT8 are both materials.
  expect_error("MAT8,1,7.+10,7.+10,.3,2.+10\n",
               "model.bdf:7 MAT8 1",
               "already by model.bdf:6 MAT1 1");
}

TEST(BadDeck, MaterialOrPlaceIsNoNumberToReckonWith) {
  expect_error("MAT1,7,,,.3\n", "model.bdf:7 MAT1 7", "neither E nor G");
  expect_error("GRID,7,,1.+200,0.,0.\n", "model.bdf:7 GRID 7", "1e+200");
  // In bounds one by one, and together not.
  expect_error(
      "PBAR,3,1,1.,1.+19,1.+19,1.\nGRID,8,,2.,0.,0.\nGRID,9,,2.,1.-150,0.\n"
      "CBAR,5,3,8,9,0.,0.,1.\n",
      "model.bdf:10 CBAR 5",
      "not a finite number");
}

// What the arithmetic behind would end with is no answer, and no crash.
TEST(BadDeck, NumberIsOfNoStructureInAnyUnits) {
  struct Case {
    const char* cards;
    const char* where;
    const char* what;
  };
  for (const Case& one : {
           Case{"PBAR,2,1,1.+38,1.-8,1.-8,1.-8\n", ":7 PBAR 2", "A is 1e+38"},
           Case{"PBAR,2,1,1.-4,1.+38,1.-8,1.-8\n", ":7 PBAR 2", "I1 is 1e+38"},
           Case{"PROD,2,1,1.+38\n", ":7 PROD 2", "A is 1e+38"},
           Case{"MAT1,2,1.-300,,.3,2700.\n", ":7 MAT1 2", "E is 1e-300"},
           Case{"MAT1,2,7.+10,,.3,1.+300\n", ":7 MAT1 2", "RHO is 1e+300"},
           Case{"MAT1,2,7.+10,,.3,1.-300\n", ":7 MAT1 2", "RHO is 1e-300"},
           Case{"CONM2,2,1,,1.+40\n", ":7 CONM2 2", "M is 1e+40"},
           Case{"CELAS2,2,1.+40,1,1\n", ":7 CELAS2 2", "K is 1e+40"},
           Case{"PSHELL,2,1,1.+40,1,,1\n", ":7 PSHELL 2", "T is 1e+40"},
           Case{"PARAM,WTMASS,1.+200\n", "PARAM", "WTMASS is 1e+200"},
           Case{"PARAM,WTMASS,1.-200\n", "PARAM", "WTMASS is 1e-200"},
       }) {
    expect_error(one.cards, one.where, one.what);
    expect_error(one.cards, one.where, "is plausible");
  }
}

TEST(BadDeck, ModelHasNoMassOrNothingThatMoves) {
  const std::string plate =
      "GRID,1,,0.,0.,0.\nGRID,2,,1.,0.,0.\nGRID,3,,1.,1.,0.\n"
      "PSHELL,1,1,0.01,1,,1\nCTRIA3,5,1,1,2,3\n";
  const InputError error = error_of(plate + "MAT1,1,7.+10,,.3\n");
  EXPECT_THAT(error.remedy(), HasSubstr("RHO"));
  EXPECT_THAT(error.where(), HasSubstr("model.bdf:6 MAT1 1"));
  EXPECT_THAT(error_of(plate + "MAT1,1,7.+10,,.3,2700.\n"
                               "SPC1,1,123456,1,2,3\n")
                  .what(),
              HasSubstr("nothing can move"));
}

TEST(BadDeck, ElementIsCollapsed) {
  expect_error(
      "CQUAD4,5,1,1,2,3,3\n", "model.bdf:7 CQUAD4 5", "names a grid twice");
  expect_error("GRID,5,,1.,1.,0.\nCQUAD4,5,1,1,2,3,5\n",
               "model.bdf:8 CQUAD4 5",
               "turned in on itself");  // two grids at one place
  expect_error("CQUAD4,5,1,1,3,2,4\n",
               "model.bdf:7 CQUAD4 5",
               "no area");  // crossed sides
  expect_error("GRID,5,,.1,.1,0.\nCQUAD4,5,1,1,2,5,4\n",
               "model.bdf:8 CQUAD4 5",
               "turned in on itself");  // a corner beyond 180 degrees
  expect_error("GRID,5,,.5,-.000000001\nCQUAD4,5,1,1,5,2,4\n",
               "model.bdf:8 CQUAD4 5",
               "flat at a corner");  // as good as on the side 1-2
  expect_error("GRID,5,,2.,0.,0.\nCTRIA3,5,1,1,2,5\n",
               "model.bdf:8 CTRIA3 5",
               "no area");
  expect_error("GRID,5,,0.,0.,0.\nPROD,2,1,1.-4\nCROD,5,2,1,5\n",
               "model.bdf:9 CROD 5",
               "no length");
  expect_error("GRID,5,,0.,0.,0.\nPBAR,2,1,1.-4\nCBAR,5,2,1,5,0.,0.,1.\n",
               "model.bdf:9 CBAR 5",
               "no length");
}

TEST(BadDeck, CoordinateSystemsGoRoundInARing) {
  expect_error(
      "CORD2R,5,6,0.,0.,0.,0.,0.,1.\n,1.,0.,0.\n"
      "CORD2R,6,5,0.,0.,0.,0.,0.,1.\n,1.,0.,0.\n",
      "model.bdf:7 CORD2R 5",
      "round a ring");
  expect_error("CORD2R,5,6,0.,0.,0.,0.,0.,1.\n,1.,0.,0.\n",
               "model.bdf:7 CORD2R 5",
               "coordinate system 6 does not exist");
}

TEST(BadDeck, RangeOfGridsRunsBackwards) {
  expect_error("SPC1,1,123456,4,THRU,1\n", "model.bdf:7 SPC1 1", "backwards");
  expect_error("RBE2,5,1,123456,4,THRU,2\n", "model.bdf:7 RBE2 5", "backwards");
}

TEST(BadDeck, GridIsAttachedToNothing) {
  const Deck deck = deck_of(grid_cards_text +
                            "CQUAD4,5,1,1,2,3,4\nGRID,7,,5.,0.,0.\n"
                            "GRID,8,,6.,0.,0.\nGRID,9,,0.,0.,1.\n"
                            "PBAR,2,1,1.-4,1.-9,1.-9\nCBAR,6,2,1,2,9\n");
  ASSERT_EQ(deck.warnings.size(), 1U);  // 9 only orients the bar
  EXPECT_THAT(deck.warnings[0], HasSubstr("GRID 7 (line 8, 2 in all)"));
  EXPECT_THAT(deck.warnings[0], HasSubstr("attached to no element"));
}

TEST(BadDeck, RemarkIsMadeOncePerKindOfCard) {
  std::string cards;
  for (int id = 11; id < 15; ++id) {
    cards += fmt::format("CQUAD4,{},1,1,2,3,4\n,,,.02\n", id);
  }
  const Deck deck =
      deck_of(grid_cards_text + cards + "CTRIA3,21,1,1,2,3\n,,,.02\n");
  ASSERT_EQ(deck.warnings.size(), 3U);  // they lie on top of each other, too
  EXPECT_THAT(deck.warnings[0],
              HasSubstr("model.bdf:7 CQUAD4 11 and 3 more: the mean of its"));
  EXPECT_THAT(deck.warnings[1], HasSubstr("CTRIA3 21: the mean of its"));
}

TEST(BadDeck, CardThatDoesNothingIsNamed) {
  const std::string plate = grid_cards_text + "CQUAD4,5,1,1,2,3,4\n";
  const auto only = [&](const std::string& text) {
    const Deck deck = deck_of(text);
    return deck.warnings.size() == 1 ? deck.warnings[0] : "not one warning";
  };
  EXPECT_THAT(only(plate + "SPC1,1,123\n"),
              HasSubstr("model.bdf:8 SPC1 1: it holds nothing: no grid"));
  EXPECT_THAT(only(plate + "SPC1,1,,1,2\n"), HasSubstr("no component"));
  EXPECT_THAT(only(plate + "MAT1,8,7.+10,5.+10,.3\n"),
              HasSubstr("E, G and NU do not agree"));
  EXPECT_THAT(only("SUBCASE 1\nSPC = 1\nSUBCASE 2\nSPC = 2\nBEGIN BULK\n" +
                   plate + "SPC1,1,123,1\nSPC1,2,123,2\nENDDATA\n"),
              HasSubstr("also selects SPC 2"));
}

TEST(BadDeck, CardIsUnknown) {
  const std::string plate = "CQUAD4,5,1,1,2,3,4\n";
  expect_error(plate + "CGAP,6,1,1,2\n", "model.bdf:8", "CGAP (line 8");
  expect_error(plate + "CGAP,6,1,1,2\n", "", "missing from the model");
  expect_error(plate + "CGAP,6,1,1,2\n", "", "\"ignore_cards\": [\"CGAP\"]");
  expect_error(plate + "NSM1,6,PSHELL,.1,1\n", "", "mass is missing");
  // Left out knowingly it is a warning.
  const Deck deck = read_deck(
      write_text("gap.bdf", grid_cards_text + plate + "CGAP,6,1,1,2\n"),
      {"cgap"});
  ASSERT_EQ(deck.warnings.size(), 1U);
  EXPECT_THAT(deck.warnings[0], HasSubstr("CGAP (line 8, 1 in all)"));
}

TEST(BadDeck, HarmlessCardsAreListedOnce) {
  const Deck deck = deck_of(grid_cards_text +
                            "CQUAD4,5,1,1,2,3,4\nFORCE,1,1,,1.,1.,0.,0.\n"
                            "FORCE,1,2,,1.,1.,0.,0.\nDESVAR,1,X,1.\n"
                            "TEMPD,1,20.\nCAERO1,9\nEIGRL,1,,,10\n"
                            "SUPORT,1,123\n");
  ASSERT_EQ(deck.warnings.size(), 1U);
  EXPECT_THAT(deck.warnings[0],
              HasSubstr("CAERO1, DESVAR, FORCE, SUPORT, TEMPD"));
}

TEST(BadDeck, MaterialOfBarsMayBeNoSolids) {
  const std::string bars =
      "PBAR,2,8,1.-4,1.-9,1.-9,1.-9\n"
      "CBAR,6,2,1,2,0.,0.,1.\nCQUAD4,5,1,1,2,3,4\n";
  const std::string odd = "MAT1,8,6.66+6,1.252+6,,1.\n";
  const Deck deck = deck_of(grid_cards_text + bars + odd);
  ASSERT_EQ(deck.warnings.size(), 1U);
  EXPECT_THAT(deck.warnings[0], HasSubstr("MAT1 8"));
  EXPECT_THAT(deck.warnings[0], HasSubstr("bars and rods take E and G"));
  expect_error("PSHELL,3,8,.01\nCQUAD4,5,3,1,2,3,4\n" + odd,
               "MAT1 8",
               "no elastic material");
}

TEST(BadDeck, MassOnAGridWithoutElementIsNamed) {
  const std::string plate =
      grid_cards_text + "CQUAD4,5,1,1,2,3,4\nGRID,7,,5.,0.,0.\n";
  const Deck loose = deck_of(plate + "CONM2,9,7,,2.\nCMASS2,10,3.,7,1\n");
  ASSERT_EQ(loose.warnings.size(), 1U);  // not once more as a loose grid
  EXPECT_THAT(loose.warnings[0], HasSubstr("model.bdf:9 CONM2 9 on GRID 7"));
  EXPECT_THAT(loose.warnings[0], HasSubstr("model.bdf:10 CMASS2 10 on GRID 7"));
  EXPECT_THAT(loose.warnings[0], HasSubstr("moves in no mode"));
  for (const char* joined : {"CELAS2,11,10.,7,1\n", "RBE2,11,1,123456,7\n"}) {
    EXPECT_TRUE(deck_of(plate + "CONM2,9,7,,2.\n" + joined).warnings.empty())
        << joined;
  }
  // A dashpot holds nothing in place.
  const Deck damped = deck_of(plate + "CONM2,9,7,,2.\nCDAMP2,11,10.,7,1\n");
  EXPECT_EQ(damped.warnings.size(), 1U);
}

TEST(BadDeck, ErrorCarriesTheUnsupportedCardBehindIt) {
  const std::string grids = "GRID,1,,0.,0.,0.\nGRID,2,,1.,0.,0.\n";
  const auto expect = [](const std::string& text, const std::string& card) {
    const InputError error = error_of(text);
    EXPECT_THAT(error.what(), HasSubstr(card + " (line")) << text;
    EXPECT_THAT(error.what(), HasSubstr("not supported")) << text;
  };
  expect(grids + "PBCOMP,3\nCBEAM,5,3,1,2,0.,0.,1.\n", "PBCOMP");
  expect(grid_cards_text + "MAT3,8,1.+9\nPSHELL,2,8,.01\n", "MAT3");
  // Aerodynamics have nothing to do with a missing property.
  EXPECT_THAT(
      error_of(grid_cards_text + "CAERO1,3\nCQUAD4,5,3,1,2,3,4\n").what(),
      testing::Not(HasSubstr("CAERO1")));
}

TEST(BadDeck, MechanismNamesTheSupportThatIsMissing) {
  const InputError error = error_of(
      "SPC = 7\nBEGIN BULK\nGRID,1,,0.,0.,0.\nGRID,2,,1.,0.,0.\n"
      "GRID,3,,2.,0.,0.\nCONM2,9,3,,1.\nCELAS2,1,100.,1,1,2,1\n"
      "CELAS2,2,100.,3,1\nSPC1,8,1,1\nENDDATA\n");
  EXPECT_THAT(error.what(), HasSubstr("a mechanism"));
  EXPECT_THAT(error.what(), HasSubstr("selects SPC 7, which does not exist"));
}

std::vector<std::string> warnings_of(const std::string& text) {
  const Deck deck = deck_of(text);
  return deck_modes(deck, assemble(deck), 20).warnings;
}

// A chain of two bars along x with a pin between them, on top of
// grid_cards_text.
const std::string chain =
    "GRID,11,,0.,0.,3.\nGRID,12,,1.,0.,3.\nGRID,13,,2.,0.,3.\n"
    "PBAR,2,1,1.-4,1.-9,1.-9,2.-9\nCBAR,21,2,11,12,0.,0.,1.\n"
    "CONM2,31,11,,1.\n,1.\nCONM2,32,13,,1.\n,1.\n";

TEST(BadDeck, MechanismIsNamedWhereItMoves) {
  const std::string held = "SPC1,1,123456,11\n";
  const std::string whole = "CBAR,22,2,12,13,0.,0.,1.\n";
  const std::string pinned = "CBAR,22,2,12,13,0.,0.,1.\n,56\n";
  EXPECT_TRUE(warnings_of(grid_cards_text + chain + held + whole).empty());
  const std::vector<std::string> found =
      warnings_of(grid_cards_text + chain + held + pinned);
  ASSERT_EQ(found.size(), 1U);
  EXPECT_THAT(found[0], HasSubstr("2 motions without stiffness"));
  EXPECT_THAT(found[0], HasSubstr("GRID 13, component"));
  EXPECT_THAT(found[0], HasSubstr("SPC1"));
}

TEST(BadDeck, FreeStructureIsNoMechanismButTwoPartsAre) {
  const std::string plate = "CQUAD4,5,1,1,2,3,4\nPARAM,COUPMASS,1\n";
  EXPECT_TRUE(warnings_of(grid_cards_text + plate).empty());
  // Held in its plane: three rigid motions are left, and are allowed.
  EXPECT_TRUE(
      warnings_of(grid_cards_text + plate + "SPC1,1,126,1,THRU,4\n").empty());
  const std::vector<std::string> found = warnings_of(
      grid_cards_text + plate + chain + "CBAR,22,2,12,13,0.,0.,1.\n");
  ASSERT_EQ(found.size(), 1U);
  EXPECT_THAT(found[0], HasSubstr("6 motions without stiffness"));
}

// A grid that is held but for the spring on it, as an absorber has one, lets
// the structure go where the spring does not follow; so does a hanging on
// springs to ground. A support that nothing is joined to was meant to hold.
TEST(BadDeck, HeldGridsOnSpringsLetTheRestMove) {
  const std::string plate =
      grid_cards_text + "CQUAD4,5,1,1,2,3,4\nPARAM,COUPMASS,1\n";
  EXPECT_TRUE(warnings_of(plate + "GRID,9,,0.,0.,0.,,12456\nCONM2,9,9,,.1\n"
                                  "CELAS2,11,100.,1,3,9,3\n")
                  .empty());
  EXPECT_TRUE(warnings_of(plate + "GRID,9,,0.,0.,0.,,123456\n"
                                  "CELAS2,11,100.,1,3,9,3\n")
                  .empty());
  const std::vector<std::string> found =
      warnings_of(plate + "GRID,9,,0.,0.,0.,,123456\n");
  ASSERT_EQ(found.size(), 1U);
  EXPECT_THAT(found[0], HasSubstr("6 motions without stiffness"));
}

TEST(BadDeck, MechanismWithoutMassNamesAGrid) {
  // Two springs in a row with nothing between them and ground.
  const InputError error = error_of(
      "GRID,1,,0.,0.,0.\nGRID,2,,1.,0.,0.\nGRID,3,,2.,0.,0.\nCONM2,9,3,,1.\n"
      "CELAS2,1,100.,1,1,2,1\nCELAS2,2,100.,3,1\n");
  EXPECT_THAT(error.what(), HasSubstr("moves without stiffness or mass"));
  EXPECT_THAT(error.what(), HasSubstr("component 1"));
  EXPECT_THAT(error.where(), HasSubstr("model.bdf"));
}

}  // namespace
}  // namespace tapfit::structure
