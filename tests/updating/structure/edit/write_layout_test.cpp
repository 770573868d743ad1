// A deck with INCLUDE files is written as it came: texts are held against those
// of the originals, byte by byte, and read again as the same model.
#include "updating/structure/edit/write_layout.hpp"

#include "acquisition/foundation/input_error.hpp"
#include "tests/acquisition/support/temporary_folder.hpp"
#include "tests/support/matchers.hpp"
#include "updating/structure/deck/deck.hpp"
#include "updating/structure/edit/card_difference.hpp"

#include <gmock/gmock.h>
#include <iterator>

namespace tapfit::structure {
namespace {

namespace fs = std::filesystem;
using ::testing::ElementsAre;

const std::string mesh_text =
    "GRID,1,,0.,0.,0.\nGRID,2,,1.,0.,0.\nGRID,3,,1.,1.,0.\n"
    "GRID,4,,0.,1.,0.\nCQUAD4,1,1,1,2,3,4\n";
const std::string control_text = "SOL 103\nCEND\nINCLUDE 'case.inc'\n";
const std::string steel_card = "MAT1,2,2.1+11,,.3,7850.\n";
const std::string metals_text =
    "$ metals\nMAT1,1,7.+10,,.3,2700.\nINCLUDE 'steel.bdf'\n";
const std::string metals_line = "INCLUDE \"parts/\nmetals.bdf\"  $ own\n";
const std::string end_text = "PSHELL,1,1,0.01,1\nENDDATA\n";

std::string text_of(const fs::path& file) {
  std::ifstream stream(file, std::ios::binary);
  return {std::istreambuf_iterator<char>(stream), {}};
}

// As identified: the cards that say `old` say `now`.
CardEdit says(const std::string& old, const std::string& now) {
  return [old, now](const Card& card) -> std::optional<std::vector<Card>> {
    std::string text = card.name();
    for (std::size_t k = 1; k < 3; ++k) text += "," + card.fields[k];
    if (text != old) return std::nullopt;
    return cards_in({now});
  };
}

const CardEdit stiffer = says("MAT1,1,7.+10", "MAT1,1,7.7+10,,.3,2700.");
const std::string stiffer_text =
    "$ was: MAT1,1,7.+10,,.3,2700.\nMAT1,1,7.7+10,,.3,2700.\n";

class WriteLayout : public ::testing::Test {
 protected:
  void SetUp() override {
    for (const char* name : {"in", "in/parts", "out"}) {
      fs::create_directory(folder_.path() / name);
    }
    put("in/case.inc", "SPC = 1\n");
    put("in/parts/mesh.bdf", mesh_text);
    put("in/parts/metals.bdf", metals_text);
    put("in/parts/steel.bdf", steel_card);
    deck_ = put("in/model.bdf",
                control_text + "BEGIN BULK\nINCLUDE 'parts/mesh.bdf'\n" +
                    metals_line + end_text);
  }

  fs::path put(const std::string& name, const std::string& text) const {
    return folder_.write(name, text);
  }
  [[nodiscard]] std::string get(const std::string& name) const {
    return text_of(folder_.path() / name);
  }
  [[nodiscard]] bool has(const std::string& name) const {
    return fs::exists(folder_.path() / name);
  }

  // @return names of the files from the folder on
  std::vector<std::string> write(const std::vector<CardEdit>& edits,
                                 const std::string& target,
                                 const std::vector<std::string>& added = {},
                                 bool force = false) {
    last_ = write_layout(deck_,
                         bulk_text(change_cards(deck_, edits), added),
                         folder_.path() / target,
                         {{deck_}, force});
    std::vector<std::string> names;
    for (const fs::path& file : last_.files) {
      names.push_back(file.lexically_relative(folder_.path()).string());
    }
    return names;
  }

  // What has changed, by name and number.
  std::vector<std::string> changed(const std::string& target) const {
    std::vector<std::string> cards;
    for (const CardChange& change :
         card_difference(deck_, folder_.path() / target)) {
      cards.push_back(change.card);
    }
    return cards;
  }

  tapfit::testing::TemporaryFolder folder_;
  fs::path deck_;
  WrittenLayout last_;
};

TEST_F(WriteLayout, LeavesFilesWithoutChangesWhereTheyAre) {
  EXPECT_THAT(write({stiffer}, "out/updated.bdf"),
              ElementsAre("out/updated.bdf", "out/parts/metals.bdf"));
  EXPECT_EQ(get("out/updated.bdf"),
            "SOL 103\nCEND\nINCLUDE '../in/case.inc'\nBEGIN BULK\n"
            "INCLUDE '../in/parts/mesh.bdf'\n" +
                metals_line + end_text);
  EXPECT_EQ(
      get("out/parts/metals.bdf"),
      "$ metals\n" + stiffer_text + "INCLUDE '../../in/parts/steel.bdf'\n");
  EXPECT_THAT(changed("out/updated.bdf"), ElementsAre("MAT1 1"));
  const Deck again = read_deck(folder_.path() / "out/updated.bdf");
  EXPECT_EQ(again.materials.at(1).E, 7.7e10);
  EXPECT_EQ(again.materials.at(2).E, 2.1e11);
}

TEST_F(WriteLayout, NamesWrittenFilesAnewBesideTheirOriginals) {
  EXPECT_THAT(write({stiffer}, "in/updated.bdf"),
              ElementsAre("in/updated.bdf", "in/parts/updated-metals.bdf"));
  EXPECT_EQ(get("in/updated.bdf"),
            control_text + "BEGIN BULK\nINCLUDE 'parts/mesh.bdf'\n" +
                "INCLUDE 'parts/updated-metals.bdf'  $ own\n" + end_text);
  EXPECT_EQ(get("in/parts/updated-metals.bdf"),
            "$ metals\n" + stiffer_text + "INCLUDE 'steel.bdf'\n");
  EXPECT_EQ(get("in/parts/metals.bdf"), metals_text);
  EXPECT_THAT(changed("in/updated.bdf"), ElementsAre("MAT1 1"));
}

// The file between leads to the original, and is written for its INCLUDE alone.
TEST_F(WriteLayout, WritesWhatLeadsToAChange) {
  const CardEdit softer = says("MAT1,2,2.1+11", "MAT1,2,2.0+11,,.3,7850.");
  EXPECT_THAT(
      write({softer}, "out/updated.bdf"),
      ElementsAre(
          "out/updated.bdf", "out/parts/metals.bdf", "out/parts/steel.bdf"));
  EXPECT_EQ(get("out/parts/metals.bdf"), metals_text);
  EXPECT_THAT(changed("out/updated.bdf"), ElementsAre("MAT1 2"));
}

TEST_F(WriteLayout, IsTheOriginalWhereNothingChanges) {
  const std::string text =
      "\xEF\xBB\xBF$ plate\r\nBEGIN BULK\r\nINCLUDE 'parts/mesh.bdf'\r\n"
      "INCLUDE 'parts/metals.bdf'\r\nPSHELL,1,1,0.01,1\t$ skin\r\nENDDATA";
  deck_ = put("in/model.bdf", text);
  EXPECT_THAT(write({}, "in/updated.bdf"), ElementsAre("in/updated.bdf"));
  EXPECT_EQ(get("in/updated.bdf"), text);
}

TEST_F(WriteLayout, EndsNewLinesAsTheFileDoes) {
  deck_ = put("in/model.bdf",
              "BEGIN BULK\r\nMAT1,1,7.+10,,.3,2700.\r\n"
              "INCLUDE 'parts/mesh.bdf'\r\nPSHELL,1,1,0.01,1\r\nENDDATA");
  write({stiffer}, "out/updated.bdf", {"CONM2,9,1,,.5,,,,,+\n+,.1"});
  EXPECT_EQ(get("out/updated.bdf"),
            "BEGIN BULK\r\n$ was: MAT1,1,7.+10,,.3,2700.\r\n"
            "MAT1,1,7.7+10,,.3,2700.\r\n"
            "INCLUDE '../in/parts/mesh.bdf'\r\nPSHELL,1,1,0.01,1\r\n"
            "CONM2,9,1,,.5,,,,,+\r\n+,.1\r\nENDDATA");
}

TEST_F(WriteLayout, PutsNewCardsBehindAllWithoutAnEnd) {
  deck_ = put("in/model.bdf",
              "INCLUDE 'parts/mesh.bdf'\n" + steel_card + "PSHELL,1,2,0.01,2");
  write({}, "in/updated.bdf", {"CONM2,9,1,,.5"});
  EXPECT_EQ(get("in/updated.bdf"), text_of(deck_) + "\nCONM2,9,1,,.5\n");
  EXPECT_THAT(changed("in/updated.bdf"), ElementsAre("CONM2 9"));
}

// Behind it they would not be read.
TEST_F(WriteLayout, PutsNewCardsInFrontOfAnEndThatIsIncluded) {
  put("in/end.bdf", end_text);
  deck_ = put("in/model.bdf",
              "BEGIN BULK\nINCLUDE 'parts/mesh.bdf'\n" + metals_line +
                  "INCLUDE 'end.bdf'\n");
  EXPECT_THAT(write({}, "in/updated.bdf", {"CONM2,9,1,,.5"}),
              ElementsAre("in/updated.bdf", "in/updated-end.bdf"));
  EXPECT_EQ(get("in/updated-end.bdf"),
            "PSHELL,1,1,0.01,1\nCONM2,9,1,,.5\nENDDATA\n");
  EXPECT_THAT(changed("in/updated.bdf"), ElementsAre("CONM2 9"));
}

// A case control that is included is a file like others.
TEST_F(WriteLayout, WritesAChangedCaseControl) {
  EditedDeck edited = edit_deck(deck_, {});
  edited.replaced[3] = {"SPC = 1", "K2GG = KX"};
  ASSERT_EQ(edited.lines[3], "SPC = 1");
  last_ = write_layout(
      deck_, edited, folder_.path() / "out/updated.bdf", {{}, false});
  EXPECT_EQ(get("out/case.inc"), "SPC = 1\nK2GG = KX\n");
  EXPECT_TRUE(get("out/updated.bdf").starts_with(control_text));
}

TEST_F(WriteLayout, WritesAFileThatIsIncludedTwiceOnce) {
  put("in/held.bdf", "SPC1,1,123,4\n");
  deck_ = put("in/model.bdf",
              "BEGIN BULK\nINCLUDE 'held.bdf'\nINCLUDE 'parts/mesh.bdf'\n"
              "INCLUDE './held.bdf'\nINCLUDE 'parts/metals.bdf'\n" +
                  end_text);
  EXPECT_THAT(write({says("SPC1,1,123", "SPC1,1,12,4")}, "out/updated.bdf"),
              ElementsAre("out/updated.bdf", "out/held.bdf"));
  const std::string text = get("out/updated.bdf");
  EXPECT_THAT(text, HasSubstr("INCLUDE 'held.bdf'\n"));
  EXPECT_THAT(text, HasSubstr("INCLUDE './held.bdf'\n"));
  EXPECT_THAT(changed("out/updated.bdf"), ElementsAre("SPC1 1", "SPC1 1"));
}

// What stands behind ENDDATA is no card.
TEST_F(WriteLayout, KeepsAFileApartThatChangesAtOneOfItsPlaces) {
  const std::string text = "BEGIN BULK\nINCLUDE 'parts/mesh.bdf'\n" +
                           metals_line + end_text +
                           "INCLUDE 'parts/metals.bdf'\n";
  deck_ = put("in/model.bdf", text);
  EXPECT_THAT(write({stiffer}, "out/updated.bdf"),
              ElementsAre("out/updated.bdf", "out/parts/metals.bdf"));
  EXPECT_EQ(get("out/updated.bdf"),
            "BEGIN BULK\nINCLUDE '../in/parts/mesh.bdf'\n" + metals_line +
                end_text + "INCLUDE '../in/parts/metals.bdf'\n");
}

// A name may count from the deck's folder; that is another one now.
TEST_F(WriteLayout, WritesWhatWouldNotFindItsFilesFromTheNewDeck) {
  put("in/parts/metals.bdf", "INCLUDE 'parts/steel.bdf'\n");
  deck_ = put("in/model.bdf",
              "BEGIN BULK\nINCLUDE 'parts/mesh.bdf'\n" + metals_line +
                  "PSHELL,1,2,0.01,2\nENDDATA\n");
  EXPECT_THAT(write({}, "out/updated.bdf"),
              ElementsAre("out/updated.bdf", "out/parts/metals.bdf"));
  EXPECT_EQ(get("out/parts/metals.bdf"), "INCLUDE '../in/parts/steel.bdf'\n");
  EXPECT_TRUE(changed("out/updated.bdf").empty());
  // In the old folder it finds them.
  EXPECT_THAT(write({}, "in/updated.bdf"), ElementsAre("in/updated.bdf"));
}

TEST_F(WriteLayout, KeepsFilesOfFoldersAboveBesideTheDeck) {
  put("metals.bdf", "MAT1,1,7.+10,,.3,2700.\n");
  deck_ =
      put("in/model.bdf",
          "BEGIN BULK\nINCLUDE 'parts/mesh.bdf'\nINCLUDE '../metals.bdf'\n" +
              end_text);
  EXPECT_THAT(write({stiffer}, "out/updated.bdf"),
              ElementsAre("out/updated.bdf", "out/metals.bdf"));
  EXPECT_THAT(get("out/updated.bdf"), HasSubstr("INCLUDE 'metals.bdf'\n"));
  EXPECT_THAT(changed("out/updated.bdf"), ElementsAre("MAT1 1"));
}

TEST_F(WriteLayout, WritesOverNoFileOfOthers) {
  fs::create_directory(folder_.path() / "out/parts");
  put("out/parts/metals.bdf", "MAT1,7,1.+10,,.3,2700.\n");
  for (const bool force : {false, true}) {
    EXPECT_THAT(write({stiffer}, "out/updated.bdf", {}, force),
                ElementsAre("out/updated.bdf", "out/parts/updated-metals.bdf"));
    EXPECT_EQ(get("out/parts/metals.bdf"), "MAT1,7,1.+10,,.3,2700.\n");
  }
  EXPECT_THAT([&] { write({stiffer}, "out/updated.bdf"); },
              Refuses("is there already"));
  // A second deck beside the first takes none of its files.
  EXPECT_THAT(write({stiffer}, "out/second.bdf", {}, true),
              ElementsAre("out/second.bdf", "out/parts/second-metals.bdf"));
}

TEST_F(WriteLayout, ReplacesTheFilesOfTheDeckThatItReplaces) {
  write({stiffer}, "out/updated.bdf");
  const CardEdit softer = says("MAT1,1,7.+10", "MAT1,1,6.+10,,.3,2700.");
  EXPECT_THAT(write({softer}, "out/updated.bdf", {}, true),
              ElementsAre("out/updated.bdf", "out/parts/metals.bdf"));
  EXPECT_EQ(read_deck(folder_.path() / "out/updated.bdf").materials.at(1).E,
            6e10);
  EXPECT_EQ(get("in/parts/metals.bdf"), metals_text);
}

// A mistake in one file leaves none.
TEST_F(WriteLayout, WritesAllFilesOrNone) {
  put("out/parts", "no folder\n");
  EXPECT_THAT([&] { write({stiffer}, "out/updated.bdf"); },
              Refuses("cannot be written"));
  EXPECT_FALSE(has("out/updated.bdf"));
}

TEST_F(WriteLayout, SaysWhereNoLineCanNameAFile) {
  fs::create_directory(folder_.path() / "in/it's \"new\"");
  put("in/it's \"new\"/model.bdf", mesh_text);
  deck_ = put("in/it's \"new\"/deck.bdf",
              "BEGIN BULK\nINCLUDE 'model.bdf'\n" + steel_card +
                  "PSHELL,1,2,0.01,2\nENDDATA\n");
  EXPECT_TRUE(write({}, "out/updated.bdf").empty());
  EXPECT_THAT(last_.hindrance, HasSubstr("no INCLUDE line can name a file"));
  EXPECT_FALSE(has("out/updated.bdf"));
}

}  // namespace
}  // namespace tapfit::structure
