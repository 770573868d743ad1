// Decks are written in the style that they came in, or as bulk data where a
// deck of keywords goes to a file of another name.
#include "updating/export/written_deck.hpp"

#include "acquisition/foundation/input_error.hpp"
#include "tests/updating/support/inp_support.hpp"
#include "updating/export/updated_deck.hpp"
#include "updating/structure/abaqus/keyword_shapes.hpp"

namespace tapfit::updating {
namespace {

namespace fs = std::filesystem;

structure::Deck brick() {
  return structure::deck_of_inp(structure::one_brick() +
                                structure::brick_section +
                                "*BOUNDARY\n1, 1, 3\n2, 3, 3\n4, 1, 3\n");
}

WrittenDeck with_a_mass(const structure::Deck& deck, const fs::path& target) {
  UpdatedDeck updated;
  updated.changes = structure::change_cards(deck.path, {});
  updated.added = {"$ added", "CONM2,9,7,,100.0000"};
  updated.damping = {{12.5, 0.01}};
  return write_as_read(deck, updated, target, {{deck.path}, true});
}

TEST(WrittenDeckTest, NameOfTheFileSaysTheStyleOfKeywords) {
  const structure::Deck deck = brick();
  const fs::path folder = deck.path.parent_path();
  const WrittenDeck keywords = with_a_mass(deck, folder / "updated.inp");
  const WrittenDeck bulk = with_a_mass(deck, folder / "updated.bdf");
  EXPECT_TRUE(structure::is_keyword_deck(folder / "updated.inp"));
  EXPECT_FALSE(structure::is_keyword_deck(folder / "updated.bdf"));
  const Eigen::VectorXd hz =
      structure::hz_of(structure::read_deck(folder / "updated.inp"), 6);
  const Eigen::VectorXd expected =
      structure::hz_of(structure::read_deck(folder / "updated.bdf"), 6);
  EXPECT_LT((hz - expected).norm(), 1e-9 * expected.norm());
  EXPECT_GT((hz - structure::hz_of(deck, 6)).norm(), 1e-3 * hz.norm());
  // Damping is a table of bulk data, and no keyword of the model.
  EXPECT_TRUE(bulk.notes.empty());
  ASSERT_EQ(keywords.notes.size(), 1U);
  EXPECT_TRUE(
      keywords.notes[0].starts_with("not written: the measured damping"))
      << keywords.notes[0];
}

TEST(WrittenDeckTest, BulkDataIsNotNamedAsKeywords) {
  acquisition::TestBundle bundle;
  bundle.deck = brick().path;
  const fs::path folder = bundle.deck->parent_path();
  EXPECT_NO_THROW(check_deck_name(bundle, folder / "new.inp"));
  EXPECT_NO_THROW(check_deck_name(bundle, folder / "new.bdf"));
  bundle.deck = structure::write_text("model.bdf", "GRID,1,,0.,0.,0.\n");
  EXPECT_NO_THROW(check_deck_name(bundle, folder / "new.bdf"));
  EXPECT_THROW(check_deck_name(bundle, folder / "new.inp"), InputError);
  EXPECT_THROW(check_deck_name(bundle, folder), InputError);
}

}  // namespace
}  // namespace tapfit::updating
