#include "acquisition/foundation/input_error.hpp"
#include "tests/support/matchers.hpp"
#include "tests/updating/support/deck_support.hpp"
#include "updating/structure/cards/bulk_numbers.hpp"
#include "updating/structure/deck/constraint_axes.hpp"
#include "updating/structure/edit/rescale_cards.hpp"

namespace tapfit::structure {
namespace {

using testing::Contains;

const std::string plate = R"(GRID,1,,0.,0.,0.
GRID,2,,1.,0.,0.
GRID,3,,1.,1.,0.
GRID,4,,0.,1.,0.
CQUAD4,1,1,1,2,3,4
PSHELL,1,1,0.01,1,,1
MAT1,1,7.+10,,.3,2700.
)";

std::string error_of(const std::string& text) {
  return refusal_of([&] { static_cast<void>(deck_of(text)); });
}

TEST(ParseReal, ReadsEveryWayOfWritingANumber) {
  EXPECT_EQ(parse_real("1.5-3"), 1.5e-3);
  EXPECT_EQ(parse_real("1.5+3"), 1.5e3);
  EXPECT_EQ(parse_real("-1.5D-3"), -1.5e-3);
  EXPECT_EQ(parse_real("7.E+10"), 7e10);
  EXPECT_EQ(parse_real("7.e10"), 7e10);
  EXPECT_EQ(parse_real("+.5"), 0.5);
  EXPECT_EQ(parse_real("3"), 3.0);
  for (const char* bad : {"", "x", "1.5-", "1..2", "nan", "inf", "1.+999"}) {
    EXPECT_FALSE(parse_real(bad).has_value()) << bad;
  }
}

TEST(ReadDeck, ReadsTheThreeFormatsAlike) {
  const std::string rest = plate.substr(plate.find("GRID,2"));
  const std::string free = "GRID,1,,1.5-1,2.5,.25,,6\n";
  const std::string small =
      "GRID    1               .15     2.5     .25             6\n";
  const std::string large =
      "GRID*   1                               .15             2.5\n"
      "*       .25                             6\n";
  const std::string tabs = "GRID\t1\t\t.15\t2.5\t.25\t\t6\n";
  for (const std::string& first : {free, small, large, tabs}) {
    const Deck deck = deck_of(first + rest);
    EXPECT_TRUE(deck.grids[0].position.isApprox(
        Eigen::Vector3d(0.15, 2.5, 0.25), 1e-15))
        << first;
    ASSERT_EQ(deck.constraints.size(), 1u) << first;
    EXPECT_EQ(deck.constraints[0].components, "6");
  }
}

TEST(ReadDeck, JoinsContinuationsOfEveryForm) {
  const std::string small =
      "CONM2   9       1       0       2.      .1      .2      .3"
      "              +X\n"
      "+X      1.      .5      2.                      3.\n";
  const std::string blank = "CONM2,9,1,0,2.,.1,.2,.3\n,1.,.5,2.,,,3.\n";
  const std::string plus = "CONM2,9,1,0,2.,.1,.2,.3,,+\n+,1.,.5,2.,,,3.\n";
  const std::string comment =
      "CONM2,9,1,0,2.,.1,.2,.3 $ a mass\n$ between\n\n,1.,.5,2.,,,3.\n";
  for (const std::string& card : {small, blank, plus, comment}) {
    const Deck deck = deck_of(plate + card);
    ASSERT_EQ(deck.masses.size(), 1u) << card;
    EXPECT_EQ(deck.masses[0].inertia(1, 0), -0.5) << card;
    EXPECT_EQ(deck.masses[0].inertia(2, 2), 3.0) << card;
    EXPECT_EQ(deck.masses[0].offset.z(), 0.3) << card;
  }
}

TEST(ReadDeck, JoinsAContinuationByItsMarkerPastOtherCards) {
  const std::string other = "CONM2,10,2,0,7.,,,,,+Y\n";
  const Deck deck = deck_of(plate + "CONM2,9,1,0,2.,.1,.2,.3,,+X\n" + other +
                            "CONM2,11,3,0,8.\n+Y,4.\n+X,1.,.5,2.,,,3.\n");
  ASSERT_EQ(deck.masses.size(), 3u);
  EXPECT_EQ(deck.masses[0].inertia(1, 0), -0.5);
  EXPECT_EQ(deck.masses[0].inertia(2, 2), 3.0);
  EXPECT_EQ(deck.masses[1].inertia(0, 0), 4.0);
  EXPECT_EQ(deck.masses[2].inertia.norm(), 0.0);
  EXPECT_THAT(error_of(plate + "CONM2,9,1,0,2.,,,,,+X\n+Z,1.\n"),
              HasSubstr("follows no entry"));
}

TEST(ReadDeck, RescalesACardWhoseLinesLieApart) {
  const std::string scattered =
      "PBAR,5,1,1.,2.,3.,4.,,,+A\nCONM2,9,1,0,2.\n+A,.1\nCONM2,10,2,0,2.\n";
  std::vector<bool> done;
  const std::vector<CardScale> twice{{"PBAR", 5, {3}, 2.0}};
  std::string text;
  for (const std::string& line :
       edit_cards(write_text("in.bdf", plate + scattered),
                  {rescale_cards(twice, done)})) {
    text += line + "\n";
  }
  const Deck deck = deck_of(text);
  EXPECT_EQ(deck.masses.size(), 2u);
  EXPECT_EQ(deck.bar_properties.at(5).area, 2.0);
  EXPECT_EQ(deck.bar_properties.at(5).J, 4.0);
}

TEST(ReadDeck, IgnoresTheByteOrderMarkOfAnEditor) {
  const Deck deck = deck_of("\xEF\xBB\xBFGRID,77,,0.,0.,0.\n" + plate);
  EXPECT_TRUE(deck.has_grid(77));
}

TEST(ReadDeck, SkipsExecutiveAndCaseControl) {
  const Deck deck = deck_of(
      "SOL 103\nCEND\nTITLE = GRID,1\nSPC = 2\n"
      "BEGIN BULK\n" +
      plate +
      "SPC1,1,123,1\nSPC1,2,456,2,THRU,4\nENDDATA\n"
      "GRID,1,,9.,9.,9.\n");
  EXPECT_EQ(deck.grids.size(), 4u);
  ASSERT_EQ(deck.constraints.size(), 3u);  // only set 2 is selected
  EXPECT_EQ(deck.constraints[0].grid, 2);
  EXPECT_EQ(deck.constraints[2].grid, 4);
  EXPECT_EQ(deck.constraints[0].components, "456");
}

TEST(ReadDeck, TakesEverySetWithoutSelectionAndSumsWithSpcadd) {
  const std::string sets = "SPC,1,1,123\nSPC1,2,456,2\nSPCADD,7,1,2\n";
  EXPECT_EQ(deck_of(plate + sets).constraints.size(), 2u);
  EXPECT_EQ(deck_of("SOL 103\nCEND\nSPC=7\nBEGIN BULK\n" + plate + sets)
                .constraints.size(),
            2u);
}

TEST(ReadDeck, BringsInIncludedFiles) {
  write_text("more.inc", "CONM2,9,1,0,2.\n");
  const Deck deck = deck_of(plate + "INCLUDE 'more.inc'\n");
  EXPECT_EQ(deck.masses.size(), 1u);
  EXPECT_THAT(deck.cards, Contains("CONM2,9,1,0,2."));
  // A long name goes on in the next line.
  EXPECT_EQ(deck_of(plate + "INCLUDE 'mo\n  re.inc'\n").masses.size(), 1u);
  EXPECT_THAT(error_of(plate + "INCLUDE 'more.inc\n"),
              HasSubstr("does not end"));
}

TEST(ReadDeck, TurnsCoordinateSystems) {
  // x of system 1 is basic y, z stays; origin at (1, 2, 3).
  const Deck deck = deck_of("CORD2R,1,0,1.,2.,3.,1.,2.,4.\n,1.,3.,3.\n" +
                            plate + "GRID,5,1,10.,0.,1.,1,1\n");
  EXPECT_TRUE(deck.grids[4].position.isApprox(Eigen::Vector3d(1, 12, 4)));
  const ConstraintAxes axes = constraint_axes(deck);
  ASSERT_EQ(axes.held.size(), 1u);
  EXPECT_EQ(axes.held.begin()->second, "2");  // x of CD 1 is basic y
  EXPECT_TRUE(axes.turned.empty());
}

TEST(ReadDeck, ReadsMaterialsFromAnyTwoModuli) {
  const Deck deck = deck_of(plate +
                            "MAT1,2,2.6+11,1.+11,,1.\n"
                            "MAT1,3,,1.+11,.3,1.\n"
                            "MAT8,4,1.+10,1.+9,.3,5.+8,2.+8,1.+8,400.\n");
  EXPECT_DOUBLE_EQ(deck.materials.at(1).G, 7e10 / 2.6);
  EXPECT_NEAR(deck.materials.at(2).nu, 0.3, 1e-12);
  EXPECT_DOUBLE_EQ(deck.materials.at(3).E, 2.6e11);
  EXPECT_TRUE(deck.materials.at(4).orthotropic);
  EXPECT_EQ(deck.materials.at(4).rho, 400.0);
}

TEST(ReadDeck, ReadsBarSectionsAndReleases) {
  const Deck deck = deck_of(plate +
                            "CBAR,5,2,1,2,0.,0.,1.\n,45,6,.1,,,.1\n"
                            "PBARL,2,1,,BAR\n,.02,.01,3.\n"
                            "CONROD,6,1,3,1,1.-4\n");
  EXPECT_EQ(deck.bars[0].released[0], "45");
  EXPECT_EQ(deck.bars[0].released[1], "6");
  EXPECT_EQ(deck.bars[0].offsets[1].x(), 0.1);
  const BarProperty& p = deck.bar_properties.at(2);
  EXPECT_NEAR(p.I1, 0.02 * 1e-6 / 12, 1e-20);
  EXPECT_NEAR(p.I2, 0.01 * 8e-6 / 12, 1e-20);
  EXPECT_EQ(p.nonstructural, 3.0);
  EXPECT_EQ(deck.rods[0].property, -6);
}

TEST(ReadDeck, NamesUnknownCards) {
  const std::string error = error_of(plate + "RSPLINE,9,1\nRSPLINE,10,1\n");
  EXPECT_THAT(error, HasSubstr("RSPLINE (line 8, 2 in all)"));
  EXPECT_THAT(error, HasSubstr("rigid connection"));
}

TEST(ReadDeck, SaysWhatIsWrongAndWhere) {
  const auto expect = [](const std::string& text, const std::string& what) {
    const std::string error = error_of(text);
    EXPECT_THAT(error, HasSubstr(what)) << text;
    EXPECT_THAT(error, HasSubstr("model.bdf")) << text;
  };
  expect(plate + "GRID,x,,0.,0.,0.\n", "model.bdf:8 GRID x");
  expect(plate + "GRID,5,,zero,0.,0.\n", "\"zero\", a number is needed");
  expect(plate + "GRID,1,,0.,0.,0.\n", "exists already");
  expect(plate + "GRID,5,9,0.,0.,0.\n", "coordinate system 9");
  expect(plate + "CQUAD4,2,1,1,2,3,9\n", "grid 9 does not exist");
  expect(plate + "CQUAD4,2,7,1,2,3,4\n", "PSHELL 7 does not exist");
  expect(plate + "CQUAD4,1,1,1,2,3,4\n", "element of this id");
  expect(plate + "CQUAD4,2,1,1,2,3,3\n", "names a grid twice");
  expect(plate + "PSHELL,2,8,.01\n", "material 8 does not exist");
  expect(plate + "PSHELL,2,1,-.01\n", "thickness");
  expect(plate + "MAT1,2,1.+9,,1.3\n", "no elastic material");
  expect(plate + "MAT8,2,1.1+10,0.,.4,.7+9\n", "E2 = 0,");
  expect(plate + "GRID,99999999999,,0.,0.,0.\n", "at most 2147483647");
  expect(plate + "SPC1,1,127,1\n", "digits 1 to 6");
  expect(plate + "SPC1,1,123,99\n", "grid 99 does not exist");
  expect(plate + "CELAS2,9,1.,1,7\n", "component 7");
  expect(plate + "GRID,5,,0.,0.,0.,9\n", "coordinate system 9");
  expect(plate + "CORD1R,3,1,2,9\n", "grid 9 does not exist");
  expect(plate + "CDAMP1,9,7,1,3\n", "PDAMP 7 does not exist");
  expect(plate + "CDAMP2,9,-2.,1,3\n", "drives the structure");
  expect(plate + "PBUSH,7,B,-2.\nCBUSH,9,7,1,,,,,0\n", "drives the structure");
  expect(plate + "CBAR,9,2,1,2,1.,0.,0.\nPBAR,2,1,1.,1.,1.\n", "along the bar");
  expect(plate + "PBARL,2,1,,GBOX\n,1.,1.\n", "GBOX");
  expect(plate + "INCLUDE 'absent.inc'\n", "cannot open");
  // A file whose reading fails, as on a broken disk: nothing is at its start.
  expect(plate + "INCLUDE '/proc/self/mem'\n", "cannot be read to its end");
  expect("+,1.,2.\n" + plate, "follows no entry");
  expect(plate + "CORD2R,1,,0.,0.,0.,0.,0.,1.\n,0.,0.,2.\n", "on a line");
  expect(plate + "GRID,5,,1,2,3,4,5,6,7,8,9,10\n", "fields");
  expect("$ nothing\n", "no GRID");
}

TEST(WriteDeck, KeepsEveryLineAndAddsBeforeEnddata) {
  const std::string text = "SOL 103\nCEND\nBEGIN BULK\n$ my plate\n" + plate;
  const Deck deck = deck_of(text + "ENDDATA\n");
  const std::filesystem::path out = write_text("out.bdf", "");
  write_deck(deck, {"CONM2,9,1,,0.05"}, out, {{}, true});
  std::ifstream file(out);
  const std::string written((std::istreambuf_iterator<char>(file)), {});
  EXPECT_EQ(written, text + "CONM2,9,1,,0.05\nENDDATA\n");
  EXPECT_EQ(read_deck(out).masses.size(), 1u);
}

}  // namespace
}  // namespace tapfit::structure
