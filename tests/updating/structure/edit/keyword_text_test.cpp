// An updated .inp, read again, is the model whose translation was changed: the
// same cards are put into its bulk data, and modes are compared. What does not
// change is compared to the byte.
#include "updating/structure/edit/keyword_text.hpp"

#include "tests/updating/support/inp_support.hpp"
#include "updating/structure/edit/card_difference.hpp"
#include "updating/structure/edit/release_constraints.hpp"
#include "updating/structure/edit/weaken_cards.hpp"
#include "updating/structure/edit/write_layout.hpp"
#include "updating/structure/elements/dashpots.hpp"

#include <iterator>
#include <tuple>

namespace tapfit::structure {
namespace {

namespace fs = std::filesystem;
using ::testing::HasSubstr;
using ::testing::Not;
using Lines = std::vector<std::string>;

// Four shells and two beams in a row, clamped at one end.
std::string strip_mesh() {
  std::string text = "*NODE\n";
  for (int k = 0; k < 5; ++k) {
    text += fmt::format("{}, {}, 0., 0.\n{}, {}, .1, 0.\n",
                        2 * k + 1,
                        0.1 * k,
                        2 * k + 2,
                        0.1 * k);
  }
  text += "11, .4, .05, .1\n*ELEMENT, TYPE=S4, ELSET=PLATE\n";
  for (int k = 0; k < 4; ++k) {
    text += fmt::format("{}, {}, {}, {}, {}\n",
                        k + 1,
                        2 * k + 1,
                        2 * k + 3,
                        2 * k + 4,
                        2 * k + 2);
  }
  return text +
         "*Element, type=B31, elset=Bars\n 11, 9, 11\n 12, 10, 11\n"
         "*NSET, NSET=FIX\n1, 2\n";
}

const std::string strip_sections =
    "*SHELL SECTION, ELSET=PLATE, MATERIAL=STEEL\n 0.002\n"
    "*Beam General Section, elset=Bars, section=GENERAL, material=ALU\n"
    " 1.0E-4, 1.0E-9, 0., 2.0E-9, 3.0E-9\n1., 0., 0.\n";
const std::string strip_materials =
    "*Material, name=STEEL\n*Elastic\n 2.1E11, 0.3\n*Density\n 7850.,\n"
    "*MATERIAL, NAME=ALU\n*ELASTIC, TYPE=ISO\n7.0E10, 0.33\n*DENSITY\n2700.\n";
const std::string strip_step =
    "*BOUNDARY\nFIX, 1, 6\n** modes\n*STEP\n*FREQUENCY\n5\n*END STEP\n";

std::string strip() {
  return strip_mesh() + strip_sections + strip_materials + strip_step;
}

std::string content_of(const fs::path& file) {
  std::ifstream stream(file, std::ios::binary);
  return {std::istreambuf_iterator<char>(stream), {}};
}

struct Written {
  Deck keywords;
  Deck bulk;  // the translation with the same cards
  std::string text;
};

Written written(const Deck& deck,
                const std::vector<CardEdit>& edits,
                const Lines& added = {}) {
  const CardChanges changes = change_cards(deck.path, edits);
  const fs::path target = deck.path.parent_path() / "updated.inp";
  const WrittenLayout layout = write_layout(deck.path,
                                            keyword_text(deck, changes, added),
                                            target,
                                            {{deck.path}, true});
  EXPECT_EQ(layout.hindrance, "");
  std::string bulk;
  for (const std::string& line : bulk_text(changes, added).text()) {
    bulk += line + "\n";
  }
  return {read_deck(target),
          read_deck(write_text("updated.bdf", bulk)),
          content_of(target)};
}

void expect_alike(const Written& both, const Deck& other_than) {
  const Eigen::VectorXd hz = hz_of(both.keywords, 6);
  const Eigen::VectorXd expected = hz_of(both.bulk, 6);
  ASSERT_EQ(hz.size(), expected.size());
  EXPECT_LT((hz - expected).norm(), 1e-6 * expected.norm()) << both.text;
  EXPECT_GT((hz - hz_of(other_than, 6)).norm(), 1e-3 * hz.norm());
}

// c on a degree of freedom.
double damping_at(const Deck& deck, int grid, int component) {
  const int dof = static_cast<int>(6 * deck.grid_index(grid)) + component - 1;
  double sum = 0.0;
  for (const Dashpot& dashpot : dashpots(deck)) {
    for (const auto& [at, b] : dashpot.direction) {
      if (at == dof) sum += dashpot.damping * b * b;
    }
  }
  return sum;
}

// Only the numbers change; lines around them stay, old ones are comments.
TEST(KeywordText, WritesNumbersWhereTheyStand) {
  const Deck deck = deck_of_inp(strip());
  const std::vector<CardScale> scales = {{"MAT1", 1, {2, 3}, 1.1},
                                         {"MAT1", 2, {5}, 0.9},
                                         {"PSHELL", 1, {3}, 1.05},
                                         {"PBEAM", 2, {4}, 1.3},
                                         {"PBEAM", 2, {7}, 0.8}};
  std::vector<bool> done;
  const Written both = written(deck, {rescale_cards(scales, done)});
  EXPECT_TRUE(std::ranges::all_of(done, [](bool d) { return d; }));
  const Material& steel = both.keywords.materials.at(1);
  EXPECT_NEAR(steel.E, 1.1 * 2.1e11, 1e-9 * steel.E);
  EXPECT_NEAR(steel.G, 1.1 * 2.1e11 / 2.6, 1e-9 * steel.G);
  EXPECT_NEAR(both.keywords.materials.at(2).rho, 0.9 * 2700.0, 1e-6);
  EXPECT_NEAR(both.keywords.shell_properties.at(1).thickness, 0.0021, 1e-12);
  const BarProperty& bar = both.keywords.bar_properties.at(2);
  EXPECT_NEAR(bar.I1, 2.6e-9, 1e-17);
  EXPECT_NEAR(bar.I2, 1.0e-9, 1e-17);
  EXPECT_NEAR(bar.J, 2.4e-9, 1e-17);
  expect_alike(both, deck);
  EXPECT_EQ(
      both.text,
      strip_mesh() +
          "*SHELL SECTION, ELSET=PLATE, MATERIAL=STEEL\n"
          "** was:  0.002\n 0.002100000000\n"
          "*Beam General Section, elset=Bars, section=GENERAL, material=ALU\n"
          "** was:  1.0E-4, 1.0E-9, 0., 2.0E-9, 3.0E-9\n"
          " 1.0E-4, 1.0E-9, 0., 2.600000000e-09, 2.400000000e-09\n1., 0., 0.\n"
          "*Material, name=STEEL\n*Elastic\n"
          "** was:  2.1E11, 0.3\n 2.310000000e+11, 0.3\n"
          "*Density\n 7850.,\n*MATERIAL, NAME=ALU\n*ELASTIC, TYPE=ISO\n"
          "7.0E10, 0.33\n*DENSITY\n** was: 2700.\n2430.000000\n" +
          strip_step);
  std::vector<std::string> changed;
  for (const CardChange& change :
       card_difference(deck.path, deck.path.parent_path() / "updated.inp")) {
    changed.push_back(change.card);
  }
  EXPECT_EQ(changed,
            (Lines{"*SHELL SECTION",
                   "*BEAM GENERAL SECTION",
                   "*ELASTIC STEEL",
                   "*DENSITY ALU"}));
}

// What does not change is the original to the byte.
TEST(KeywordText, IsTheOriginalWhereNothingChanges) {
  const Deck deck = deck_of_inp(strip());
  EXPECT_EQ(written(deck, {}).text, strip());
}

TEST(KeywordText, GivesElementsASectionOfTheirOwn) {
  const Deck deck = deck_of_inp(strip());
  const WeakenCards weak(
      deck, {{{2}, 0.4}, {{3}, 0.125, 0.5}, {{11}, 0.5}, {{12}, 0.7}});
  const std::vector<CardScale> scales = {{"MAT1", 1, {2, 3}, 1.1}};
  std::vector<bool> done{false};
  const Written both =
      written(deck, {weak.edit(scales, done), rescale_cards(scales, done)});
  expect_alike(both, deck);
  EXPECT_NEAR(total_mass(both.keywords, assemble(both.keywords)),
              total_mass(both.bulk, assemble(both.bulk)),
              1e-9);
  // Both bars have gone: their section has nothing left.
  EXPECT_THAT(both.text,
              HasSubstr("** was: *Beam General Section, elset=Bars, "
                        "section=GENERAL, material=ALU\n"));
  EXPECT_THAT(both.text, HasSubstr("*SHELL SECTION, ELSET=TAPFIT_"));
}

// Of moduli with directions all go down, Poisson's ratios stay.
TEST(KeywordText, WeakensMaterialsWithDirections) {
  for (const std::string elastic :
       {"*ELASTIC, TYPE=ENGINEERING CONSTANTS\n"
        "1.2E11, 8.0E9, 8.0E9, 0.3, 0.3, 0.4, 4.0E9, 4.0E9,\n2.8E9\n",
        "*ELASTIC, TYPE=LAMINA\n1.2E11, 8.0E9, 0.3, 4.0E9, 4.0E9, 2.8E9\n"}) {
    std::string text = strip();
    const std::string steel = "*Elastic\n 2.1E11, 0.3\n";
    text.replace(text.find(steel), steel.size(), elastic);
    const Deck deck = deck_of_inp(text);
    const WeakenCards weak(deck, {{{2, 3}, 0.5}});
    std::vector<bool> done;
    const Written both = written(deck, {weak.edit({}, done)});
    expect_alike(both, deck);
    EXPECT_THAT(both.text, Not(HasSubstr("not written")));
  }
}

// One modulus of engineering constants stands in all of the card's numbers.
TEST(KeywordText, SaysWhichNumberHasNoPlace) {
  std::string text = strip();
  const std::string steel = "*Elastic\n 2.1E11, 0.3\n";
  text.replace(text.find(steel),
               steel.size(),
               "*ELASTIC, TYPE=ENGINEERING CONSTANTS\n"
               "1.2E11, 8.0E9, 8.0E9, 0.3, 0.3, 0.4, 4.0E9, 4.0E9,\n2.8E9\n");
  const Deck deck = deck_of_inp(text);
  const std::vector<CardScale> scales = {{"MAT8", 1, {2}, 1.1}};
  std::vector<bool> done;
  EXPECT_THAT(written(deck, {rescale_cards(scales, done)}).text,
              HasSubstr("** not written: what changes of *MATERIAL "
                        "(plate.inp:"));
}

TEST(KeywordText, FreesSupports) {
  const Deck deck = deck_of_inp(strip());
  const Written both = written(
      deck, {release_constraints(deck, {{1, "5"}, {2, "5"}, {2, "4"}})});
  expect_alike(both, deck);
  EXPECT_THAT(both.text, HasSubstr("*BOUNDARY\n** was: FIX, 1, 6\n"));
  EXPECT_THAT(both.text, HasSubstr("\n1, 1, 4\n1, 6, 6\n"));
  // A keyword without data is none.
  const Written loose = written(
      deck, {release_constraints(deck, {{1, "123456"}, {2, "123456"}})});
  EXPECT_THAT(loose.text, HasSubstr("** was: *BOUNDARY\n** was: FIX, 1, 6\n"));
  EXPECT_TRUE(loose.keywords.constraints.empty());
}

// A mass, springs to ground and between nodes, an absorber with its damper, a
// held node, and one on an arm.
TEST(KeywordText, AddsWhatSitsOnNodes) {
  const Deck deck = deck_of_inp(strip());
  const Lines added = {"$ added: all kinds",
                       "CONM2,21,9,,0.0500000",
                       "CELAS2,22,2000.000,10,3",
                       "CELAS2,23,5.000000,9,5",
                       "GRID,30,0,0.4000000,0.1000000,0.,0,12456",
                       "CONM2,24,30,,0.0100000",
                       "CELAS2,25,900.0000,10,3,30,3",
                       "CDAMP2,26,3.000000,10,3,30,3",
                       "CDAMP2,27,4.000000,7,2",
                       "GRID,31,0,0.4500000,0.0500000,0.,0,0",
                       "RBE2,28,9,123456,31",
                       "CONM2,29,31,,0.0200000",
                       "SPC1,1,2,11"};
  const Written both = written(deck, {}, added);
  expect_alike(both, deck);
  EXPECT_THAT(both.text, HasSubstr("** added: all kinds\n"));
  EXPECT_THAT(both.text, HasSubstr("** CalculiX passes over springs on"));
  EXPECT_THAT(both.text, HasSubstr("*BOUNDARY\n11, 2, 2\n*STEP\n"));
  // Dampers act alike: along the line of two nodes, and on one component.
  for (const auto& [grid, component, c] :
       {std::tuple{7, 2, 4.0}, {7, 1, 0.0}, {10, 3, 3.0}, {30, 3, 3.0}}) {
    EXPECT_NEAR(damping_at(both.keywords, grid, component), c, 1e-9);
    EXPECT_NEAR(damping_at(both.bulk, grid, component), c, 1e-9);
  }
  // What CalculiX stops at is a comment.
  const Lines turning = {"CONM2,21,9,,0.05,,,,,+\n+,1.0E-5,,1.0E-5,,,1.0E-5",
                         "CDAMP2,22,4.000000,7,5",
                         "DMIG,K2GG,0,6,2,0",
                         "DMIG,K2GG,7,1,,7,1,1000."};
  const std::string text = written(deck, {}, turning).text;
  EXPECT_THAT(text, HasSubstr("** not written: the rotary inertia at node 9"));
  EXPECT_THAT(text, HasSubstr("\n** *ELEMENT, TYPE=ROTARYI"));
  EXPECT_THAT(text, HasSubstr("** not written: the damper on a rotation"));
  EXPECT_THAT(text, HasSubstr("** not written: the stiffness matrix K2GG"));
}

// New files stand beside the deck, those that do not change stay.
TEST(KeywordText, KeepsIncludeFiles) {
  write_text("mesh.inc", strip_mesh());
  write_text("metals.inc", strip_materials);
  const Deck deck =
      deck_of_inp("*HEADING\nstrip\n*INCLUDE, INPUT=mesh.inc\n" +
                  strip_sections + "*Include, input=metals.inc\n" + strip_step);
  const fs::path folder = deck.path.parent_path();
  for (const char* old : {"updated.inp", "updated-metals.inc"}) {
    fs::remove(folder / old);
  }
  const std::vector<CardScale> scales = {{"MAT1", 1, {2, 3}, 1.1}};
  std::vector<bool> done;
  const CardChanges changes =
      change_cards(deck.path, {rescale_cards(scales, done)});
  const WrittenLayout layout = write_layout(deck.path,
                                            keyword_text(deck, changes, {}),
                                            folder / "updated.inp",
                                            {{deck.path}, true});
  EXPECT_EQ(layout.files,
            (std::vector<fs::path>{folder / "updated.inp",
                                   folder / "updated-metals.inc"}));
  EXPECT_EQ(content_of(folder / "updated.inp"),
            "*HEADING\nstrip\n*INCLUDE, INPUT=mesh.inc\n" + strip_sections +
                "*Include, input=updated-metals.inc\n" + strip_step);
  EXPECT_NEAR(
      read_deck(folder / "updated.inp").materials.at(1).E, 2.31e11, 1.0);
}

// Elements and nodes stand in the part, holds outside it name its instance.
TEST(KeywordText, AddsToThePartOfAnAssembly) {
  const Deck deck = deck_of_inp(
      "*PART, NAME=P\n" + strip_mesh() + strip_sections +
      "*END PART\n*ASSEMBLY, NAME=A\n*INSTANCE, NAME=P-1, PART=P\n"
      "*END INSTANCE\n*NSET, NSET=HELD, INSTANCE=P-1\n1, 2\n*END ASSEMBLY\n" +
      strip_materials +
      "*BOUNDARY\nHELD, 1, 6\n*STEP\n*FREQUENCY\n5\n"
      "*END STEP\n");
  const Written both =
      written(deck,
              {release_constraints(deck, {{1, "5"}, {2, "5"}})},
              {"CONM2,21,9,,0.0500000", "SPC1,1,2,11"});
  expect_alike(both, deck);
  EXPECT_THAT(both.text, HasSubstr("21, 9\n*MASS"));
  EXPECT_LT(both.text.find("*MASS"), both.text.find("*END PART"));
  EXPECT_THAT(both.text, HasSubstr("\nP-1.1, 1, 4\nP-1.1, 6, 6\n"));
  EXPECT_THAT(both.text, HasSubstr("*BOUNDARY\nP-1.11, 2, 2\n*STEP"));
}

// A joint along no axis of the deck needs nodes with axes of their own: its
// elements stay where they are.
TEST(KeywordText, LeavesOutWhatNeedsAxesOfItsOwn) {
  const Deck deck = deck_of_inp(strip());
  const CardEdit moved =
      [](const Card& card) -> std::optional<std::vector<Card>> {
    if (card.name() != "CQUAD4" || card.fields[1] != "4") return std::nullopt;
    Card other = card;
    for (std::string& field : other.fields) field = field == "7" ? "30" : field;
    return std::vector{other};
  };
  const Lines added = {"CORD2R,1,0,0.,0.,0.,1.,1.,0.\n,1.,0.,0.",
                       "GRID,30,0,0.3,0.,0.,0,0",
                       "GRID,31,0,0.3,0.,0.,1,0",
                       "RBE2,40,7,123456,31",
                       "RBE2,41,31,123456,30"};
  const Written both = written(deck, {moved}, added);
  EXPECT_THAT(both.text, HasSubstr("** not written: a joint along no axis"));
  EXPECT_THAT(both.text, HasSubstr("\n4, 7, 9, 10, 8\n"));
  EXPECT_THAT(both.text, Not(HasSubstr("30,")));
  // A joint along an axis takes them.
  const Lines along = {"GRID,30,0,0.3,0.,0.,0,0",
                       "RBE2,40,7,12346,30",
                       "CELAS2,41,10.00000,30,5,7,5"};
  const Written jointed = written(deck, {moved}, along);
  expect_alike(jointed, deck);
  EXPECT_THAT(jointed.text, HasSubstr("\n4, 30, 9, 10, 8\n"));
}

}  // namespace
}  // namespace tapfit::structure
