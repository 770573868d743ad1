#include "updating/structure/edit/weaken_cards.hpp"

#include "tests/updating/support/deck_support.hpp"
#include "updating/structure/assembly/assemble.hpp"

namespace tapfit::structure {
namespace {

const std::string model =
    "GRID,1,,0.,0.,0.\nGRID,2,,.1,0.,0.\nGRID,3,,.1,.1,0.\n"
    "GRID,4,,0.,.1,0.\nGRID,5,,.2,0.,0.\nGRID,6,,.2,.1,0.\n"
    "CQUAD4,1,1,1,2,3,4\nCQUAD4,2,1,2,5,6,3\n"
    "CBAR,3,2,1,2,0.,0.,1.\nCBAR,4,2,2,5,0.,0.,1.\n"
    "PSHELL,1,1,.002,1,,1\nPBARL,2,1,,BAR\n,.01,.005\n"
    "MAT1,1,7.+10,,.3,2700.\n";

Deck written(const Deck& deck,
             const std::vector<WeakElements>& weak,
             const std::vector<CardScale>& scales) {
  const WeakenCards cards(deck, weak);
  std::vector<bool> done;
  const CardEdit rescale = rescale_cards(scales, done);
  std::string text;
  for (const std::string& line :
       edit_cards(deck.path, {cards.edit(scales, done), rescale})) {
    text += line + "\n";
  }
  EXPECT_TRUE(std::ranges::all_of(done, [](bool d) { return d; })) << text;
  return read_deck(write_text("weak.bdf", text));
}

// Read back, exactly the elements named are softer, in what is left of a
// modulus that was identified besides; the mass stays.
TEST(WeakenCards, GivesElementsAPropertyOfTheirOwn) {
  const Deck deck = deck_of(model);
  const std::vector<WeakElements> weak = {{{2}, 0.4}, {{3}, 0.7}};
  const Deck read = written(
      deck, weak, {{.name = "MAT1", .id = 1, .fields = {2, 3}, .factor = 1.1}});
  const auto part = [&deck](int id) {
    return assemble_stiffness(deck, [id](int e) { return e == id; });
  };
  const SparseMatrix expected =
      1.1 * (assemble(deck).K - 0.6 * part(2) - 0.3 * part(3));
  // Nine digits are written.
  EXPECT_LT((assemble(read).K - expected).norm(), 1e-8 * expected.norm());
  EXPECT_LT((assemble(read).M - assemble(deck).M).norm(),
            1e-12 * assemble(deck).M.norm());
}

// A shell and a PBAR of half the thickness: that of a plate, and I1, J, A of a
// flat bar; a PBARL's moduli go down instead.
TEST(WeakenCards, MakesThinnedElementsThinner) {
  const std::string flat =
      "PBAR,3,1,2.-5,2.-11,1.-10,6.-11\nCBAR,5,3,3,4,0.,0.,1.\n";
  const Deck deck = deck_of(model + flat);
  const double left = 0.5;
  const double cube = left * left * left;
  const Deck read = written(deck, {{{2, 3, 5}, cube, left}}, {});
  Deck thin = deck;
  ShellProperty& plate = thin.shell_properties[91] =
      deck.shell_properties.at(1);
  plate.thickness *= left;
  BarProperty& bar = thin.bar_properties[93] = deck.bar_properties.at(3);
  bar.area *= left;
  bar.I1 *= cube;
  bar.I2 *= left;
  // A sixth of it, 2 / (2 + 10), goes with the thickness itself.
  bar.J *= 5.0 / 6.0 * cube + left / 6.0;
  Material& soft = thin.materials[94] = deck.materials.at(1);
  soft.E *= cube;
  soft.G *= cube;
  soft.rho *= left;
  thin.bar_properties[92] = deck.bar_properties.at(2);
  thin.bar_properties[92].material = 94;
  for (Shell& e : thin.shells) {
    if (e.id == 2) e.property = 91;
  }
  for (Bar& e : thin.bars) {
    if (e.id == 3) e.property = 92;
    if (e.id == 5) e.property = 93;
  }
  const SparseMatrix K = assemble(thin).K;
  const SparseMatrix M = assemble(thin).M;
  EXPECT_LT((assemble(read).K - K).norm(), 1e-8 * K.norm());
  EXPECT_LT((assemble(read).M - M).norm(), 1e-8 * M.norm());
}

// Cards that are copied, with their own numbers unchanged, stay as they are.
TEST(WeakenCards, LeavesTheCardsThatItCopies) {
  const Deck deck = deck_of(model);
  const WeakenCards weak(deck, {{{2}, 0.4}});
  std::vector<bool> done;
  std::vector<std::string> changed;
  for (const std::string& line : edit_cards(deck.path, {weak.edit({}, done)})) {
    if (line.starts_with("$ was")) changed.push_back(line);
  }
  EXPECT_EQ(changed, (std::vector<std::string>{"$ was: CQUAD4,2,1,2,5,6,3"}));
}

TEST(WeakenCards, LeavesADeckWithoutThemAsItIs) {
  const Deck deck = deck_of(model);
  EXPECT_EQ(written(deck, {}, {}).cards, deck.cards);
}

}  // namespace
}  // namespace tapfit::structure
