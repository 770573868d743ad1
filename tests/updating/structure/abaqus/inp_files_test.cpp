// The files of a deck: *INCLUDE, what is protected from being written over, and
// what is written back.
#include "acquisition/foundation/input_error.hpp"
#include "tests/updating/support/inp_support.hpp"
#include "updating/structure/cards/bulk_cards.hpp"
#include "updating/structure/cards/bulk_lines.hpp"
#include "updating/structure/edit/edit_cards.hpp"

#include <fstream>

namespace tapfit::structure {
namespace {

namespace fs = std::filesystem;

std::vector<std::string> names_of(const std::vector<fs::path>& files) {
  std::vector<std::string> names;
  for (const fs::path& file : files) names.push_back(file.filename().string());
  return names;
}

TEST(InpFiles, IncludedOnesArePartOfTheDeck) {
  write_text("mesh.inp", one_brick());
  write_text("steel.inp", brick_section);
  const fs::path path = write_text("whole.inp",
                                   "** whole\n*INCLUDE, INPUT=mesh.inp\n"
                                   "*Include,\nINPUT=steel.inp\n");
  const Deck deck = read_deck(path);
  EXPECT_EQ(deck.solids.size(), 1U);
  EXPECT_THAT(deck.solids[0].where, HasSubstr("mesh.inp:11"));
  EXPECT_EQ(names_of(deck_files(path)),
            (std::vector<std::string>{"whole.inp", "mesh.inp", "steel.inp"}));
}

TEST(InpFiles, DeckIsToldByItsContent) {
  const fs::path path = write_text("model.dat", one_brick() + brick_section);
  EXPECT_EQ(read_deck(path).solids.size(), 1U);
  EXPECT_EQ(read_deck(write_text("bulk.inp",
                                 "GRID,1,,0.,0.,0.\nGRID,2,,1.,0.,0.\n"
                                 "CELAS2,1,5.,1,1,2,1\n"))
                .scalars.size(),
            1U);
}

TEST(InpFiles, CirclesAndMissingFilesAreRefused) {
  write_text("a.inp", "*NODE\n1, 0., 0., 0.\n*INCLUDE, INPUT=b.inp\n");
  write_text("b.inp", "*NODE\n2, 0., 0., 0.\n*INCLUDE, INPUT=a.inp\n");
  const fs::path path = write_text("c.inp", "*INCLUDE, INPUT=a.inp\n");
  EXPECT_THAT([&] { static_cast<void>(read_deck(path)); },
              Refuses("include each other without end"));
  EXPECT_EQ(deck_files(path).size(), 3U);
  const fs::path lost = write_text("d.inp", "*INCLUDE, INPUT=none.inp\n");
  EXPECT_THAT([&] { static_cast<void>(read_deck(lost)); },
              Refuses("d.inp:1: cannot open the model"));
}

TEST(InpFiles, IncludeWithoutAFileIsRefused) {
  const fs::path path = write_text("f.inp", "*NODE\n1, 0.\n*INCLUDE, FILE=a\n");
  EXPECT_THAT([&] { static_cast<void>(read_deck(path)); },
              Refuses("f.inp:3 *INCLUDE: it names no file"));
}

TEST(InpFiles, OtherFilesAreNotQuoted) {
  write_text("passwords", "root:x:0:0:root:/root:/bin/sh\nme:secret:1\n");
  const fs::path path = write_text("e.inp", "*INCLUDE, INPUT=passwords\n");
  const std::string refusal =
      refusal_of([&] { static_cast<void>(read_deck(path)); });
  EXPECT_THAT(refusal, HasSubstr("is no Abaqus or CalculiX deck"));
  EXPECT_THAT(refusal, Not(HasSubstr("secret")));
}

TEST(InpFiles, CardsOfTheTranslationAreEditedAndReadAgain) {
  const fs::path path = write_text(
      "plate.inp", one_brick() + brick_section + "*BOUNDARY\n1, 1, 3\n");
  const Deck deck = read_deck(path);
  const CardEdit softer =
      [](const Card& card) -> std::optional<std::vector<Card>> {
    if (card.name() != "MAT1") return std::nullopt;
    EXPECT_THAT(card.where, HasSubstr("plate.inp:13"));
    return cards_in({"MAT1,1,1.05+11,,.3,7800."});
  };
  Deck edited = deck;
  edited.cards = edit_cards(path, {softer});
  const fs::path written = path.parent_path() / "updated.bdf";
  write_deck(edited, {}, written, {{}, true});
  const Deck again = read_deck(written);
  EXPECT_EQ(again.materials.at(1).E, 1.05e11);
  const Eigen::VectorXd before = hz_of(deck, 12);
  const Eigen::VectorXd after = hz_of(again, 12);
  EXPECT_NEAR(after(11), before(11) / std::sqrt(2.0), 1e-6 * before(11));
  // As it was, without the edit.
  write_deck(deck, {}, written, {{}, true});
  EXPECT_NEAR(hz_of(read_deck(written), 12)(11), before(11), 1e-9 * before(11));
}

}  // namespace
}  // namespace tapfit::structure
