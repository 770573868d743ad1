// What of a deck is read: cards left out as asked, sets that the case control
// does not choose.
#include "tests/support/matchers.hpp"
#include "tests/updating/support/deck_support.hpp"

namespace tapfit::structure {
namespace {

const std::string four_grids = R"(GRID,1,,0.,0.,0.
GRID,2,,1.,0.,0.
GRID,3,,1.,1.,0.
GRID,4,,0.,1.,0.
PSHELL,1,1,0.01,1,,1
MAT1,1,7.+10,,.3,2700.
)";

// Also a card that is read; and a name that the deck does not have is said.
TEST(AskedFor, CardsAreLeftOutAsAsked) {
  const std::string text =
      four_grids + "CQUAD4,5,1,1,2,3,4\nCONM2,7,1,,2.\nCONM2,8,2,,2.\n";
  const Deck whole = deck_of(text);
  const Deck deck =
      read_deck(write_text("without.bdf", text), {"conm2", "NOSUCH"});
  EXPECT_EQ(whole.masses.size(), 2U);
  EXPECT_TRUE(deck.masses.empty());
  ASSERT_EQ(deck.warnings.size(), 2U);
  EXPECT_THAT(deck.warnings[0],
              HasSubstr("CONM2 (2 in all) left out, as asked"));
  EXPECT_THAT(deck.warnings[1], HasSubstr("no such card"));
}

const std::string held_twice = "BEGIN BULK\n" + four_grids +
                               "CQUAD4,5,1,1,2,3,4\nSPC1,9,123,1\n"
                               "SPC1,8,123,1,2\nENDDATA\n";

// Without a case control nothing is asked: all sets hold.
TEST(AskedFor, SetThatTheCaseControlDoesNotChooseIsNotInTheModel) {
  const Deck free = deck_of("SOL 103\nCEND\nMETHOD = 1\n" + held_twice);
  ASSERT_EQ(free.warnings.size(), 1U);
  EXPECT_THAT(free.warnings[0], HasSubstr("chooses no SPC"));
  EXPECT_THAT(free.warnings[0], HasSubstr("write SPC = 8"));
  EXPECT_TRUE(free.constraints.empty());
  const Deck bulk = deck_of(held_twice);
  EXPECT_EQ(bulk.constraints.size(), 3U);
  ASSERT_EQ(bulk.warnings.size(), 1U);
  EXPECT_THAT(bulk.warnings[0], HasSubstr("all hold"));
  EXPECT_EQ(deck_of("TITLE = a plate\n" + held_twice).constraints.size(), 3U);
  const Deck chosen =
      deck_of("SOL 103\nCEND\nMETHOD = 1\nSPC = 9\n" + held_twice);
  EXPECT_TRUE(chosen.warnings.empty());
  EXPECT_EQ(chosen.constraints.size(), 1U);
}

TEST(AskedFor, MpcThatTheCaseControlDoesNotChooseIsNotInTheModel) {
  const std::string bulk = "BEGIN BULK\n" + four_grids +
                           "CQUAD4,5,1,1,2,3,4\nMPC,3,1,3,1.,2,3,-1.\n"
                           "ENDDATA\n";
  const Deck none = deck_of("SOL 103\nCEND\nMETHOD = 1\n" + bulk);
  EXPECT_TRUE(none.relations.empty());
  ASSERT_EQ(none.warnings.size(), 1U);
  EXPECT_THAT(none.warnings[0], HasSubstr("chooses no MPC: set 3"));
  EXPECT_EQ(deck_of("MPC = 3\nMETHOD = 1\n" + bulk).relations.size(), 1U);
  EXPECT_EQ(deck_of(bulk).relations.size(), 1U);
}

// The subcase for modes counts, wherever it stands and however it says so.
TEST(AskedFor, FirstSubcaseForModesIsSolved) {
  for (const char* second : {"METHOD = 1",
                             "ANALYSIS = MODES",
                             "METH(STRUCTURE) = 1",
                             "ANALYSIS MODES"}) {
    const Deck deck =
        deck_of(std::string("CEND\nSUBCASE 1\nLOAD = 5\nSPC = 8\nSUBCASE 2\n") +
                second + "\nSPC = 9\n" + held_twice);
    EXPECT_EQ(deck.constraints.size(), 1U) << second;
    ASSERT_EQ(deck.warnings.size(), 1U) << second;
    EXPECT_THAT(deck.warnings[0],
                HasSubstr("selects SPC 8: the model is held as in its subcase "
                          "2, the first for modes, by SPC 9 alone"));
  }
  // Above all subcases: the first one.
  const Deck above =
      deck_of("CEND\nMETHOD = 1\nSUBCASE 1\nSPC = 8\nSUBCASE 2\nSPC = 9\n" +
              held_twice);
  EXPECT_EQ(above.constraints.size(), 2U);
  EXPECT_THAT(above.warnings[0], HasSubstr("its first subcase, by SPC 8"));
}

std::string refusal_of_deck(const std::string& text) {
  try {
    static_cast<void>(deck_of(text));
  } catch (const InputError& error) {
    return error.what();
  }
  return "accepted";
}

// What changes stiffness or mass and is not read is named, and left out only
// knowingly.
TEST(AskedFor, CaseControlThatChangesTheModelIsRefused) {
  struct Case {
    const char* command;
    const char* card;
    const char* says;
    const char* name;
  };
  for (const Case& c :
       {Case{"STATSUB = 1", "", "stiffness of the preload", "STATSUB"},
        Case{"TEMP(MATERIAL) = 4",
             "MATT1,1,7\n",
             "materials at that",
             "TEMPERATURE"},
        Case{"NSM = 5", "", "nonstructural mass", "NSM"},
        Case{
            "NSM = 5", "NSM1,5,PSHELL,1.,1\n", "nonstructural mass", "NSM1"}}) {
    const std::string text = std::string("SOL 103\nCEND\nMETHOD = 1\n") +
                             c.command + "\nBEGIN BULK\n" + four_grids +
                             c.card + "CQUAD4,5,1,1,2,3,4\nENDDATA\n";
    EXPECT_THAT(refusal_of_deck(text), HasSubstr(c.says)) << c.command;
    const Deck deck = read_deck(write_text("left_out.bdf", text), {c.name});
    ASSERT_FALSE(deck.warnings.empty()) << c.command;
    EXPECT_THAT(deck.warnings[0], HasSubstr(c.says));
  }
}

// Temperatures without materials that depend on them, nonstructural mass that
// is not chosen, structural damping; matrices of responses that are not solved.
TEST(AskedFor, CaseControlThatChangesNoModeIsAtMostNoted) {
  const auto deck = [](const std::string& control, const std::string& card) {
    return deck_of("SOL 103\nCEND\nMETHOD = 1\n" + control + "\nBEGIN BULK\n" +
                   four_grids + card + "CQUAD4,5,1,1,2,3,4\nENDDATA\n");
  };
  EXPECT_TRUE(deck("TEMP(MATERIAL) = 4", "").warnings.empty());
  EXPECT_THAT(deck("ECHO = NONE", "NSM1,5,PSHELL,1.,1\n").warnings[0],
              HasSubstr("change nothing of the modes: NSM1"));
  EXPECT_THAT(deck("K42GG = KD", "").warnings[0], HasSubstr("K42GG = KD"));
  EXPECT_THAT(deck("K2PP = KX", "").warnings[0],
              HasSubstr("K2PP = KX is not in the model"));
  EXPECT_THAT(
      refusal_of_deck("SOL 111\nCEND\nMETHOD = 1\nM2PP = MX\nBEGIN BULK\n" +
                      four_grids + "CQUAD4,5,1,1,2,3,4\nENDDATA\n"),
      HasSubstr("choose the matrix by M2GG"));
}

TEST(AskedFor, CardsWithMassOrConstraintsAreRefused) {
  EXPECT_THAT(
      refusal_of_deck(four_grids + "CQUAD4,5,1,1,2,3,4\nMFLUID,1,0,1.,1.\n"),
      HasSubstr("mass of the fluid"));
  EXPECT_THAT(refusal_of_deck(four_grids + "CQUAD4,5,1,1,2,3,4\nGMBC,1,1\n"),
              HasSubstr("a support is missing"));
}

TEST(AskedFor, CardsAreCalledWhatTheyAre) {
  const Deck deck = deck_of(four_grids +
                            "CQUAD4,5,1,1,2,3,4\nRINGFL,1,1.\nRELEASE,1,3\n"
                            "CLOAD,1,1.\nCREEP,1\nCOUNT,1\nCASECC,1\n");
  ASSERT_EQ(deck.warnings.size(), 3U);
  EXPECT_THAT(deck.warnings[0], HasSubstr("superelements are missing"));
  EXPECT_THAT(deck.warnings[1], HasSubstr("it is left out of the model"));
  EXPECT_THAT(deck.warnings[2], HasSubstr("CASECC, CLOAD, COUNT, CREEP"));
}

// Its only component is blank, 0 or 1.
TEST(AskedFor, ScalarPointIsHeldWithoutAWord) {
  for (const char* component : {"", "0", "1"}) {
    const Deck deck = deck_of("SPOINT,1,2\nCELAS4,3,10.,1,2\nCMASS4,4,1.,2\n" +
                              fmt::format("SPC1,1,{},1\n", component));
    EXPECT_TRUE(deck.warnings.empty()) << component;
    EXPECT_EQ(deck.constraints.back().grid, 1);
    EXPECT_EQ(deck.constraints.back().components, "1");
  }
}

}  // namespace
}  // namespace tapfit::structure
