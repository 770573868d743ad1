// A deck with half of its plate's thickness: no effect of that deck does as
// well as the deck put right.
#include "tests/updating/support/modal_bundle.hpp"
#include "updating/export/updated_deck.hpp"
#include "updating/session/add_diagnosed.hpp"

#include <gtest/gtest.h>

#include <fstream>
#include <iterator>
#include <string>
#include <vector>

namespace tapfit::updating {
namespace {

std::string halved(std::string text) {
  const std::string whole = "PSHELL,1,1,.003";
  return text.replace(text.find(whole), whole.size(), "PSHELL,1,1,.0015");
}

std::string read(const std::filesystem::path& path) {
  std::ifstream file(path);
  return {std::istreambuf_iterator<char>(file), {}};
}

class CorrectedDeck : public ::testing::Test {
 protected:
  CorrectedDeck() {
    const std::string text = testing::plate_text({});
    const std::vector<Dof> points = testing::plate_points();
    testing::write_modal_bundle(
        folder_,
        halved(text),
        testing::true_modes(text, points, 6),
        points,
        {},
        R"(, "uncertain": [{"material": 1, "property": "E",
                            "sd_percent": 3}])");
  }

  tapfit::testing::TemporaryFolder folder_;
};

TEST_F(CorrectedDeck, IsNamedAddedAndTakenBack) {
  const std::string deck = read(folder_.path() / "model.bdf");
  Session session(folder_.path());
  const Diagnosis d = session.diagnosis();
  EXPECT_EQ(d.verdict, "card-swap");
  ASSERT_EQ(d.ladder.size(), 1U);
  EXPECT_EQ(d.ladder[0].where.variant, "T-times-2");
  ASSERT_FALSE(d.set_up.empty());
  EXPECT_EQ(d.set_up[0].edit, "model: PSHELL 1, T times 2");
  EXPECT_GT(d.error_fitted, 10.0 * d.error_best);
  EXPECT_LT(d.error_best, 1.3 * d.floor);

  add_ladder(session, d, {});
  EXPECT_NEAR(session.ladder().back().error, d.error_best, 0.01 * d.error_best);
  // E is what it was, since the thickness is right.
  EXPECT_NEAR(session.model_parameters().front().value, 70e9, 1e9);

  write_updated_deck(session, folder_.path() / "updated.bdf", {}, {});
  const std::string updated = read(folder_.path() / "updated.bdf");
  EXPECT_NE(updated.find("PSHELL,1,1,3.00000000E-03"), std::string::npos)
      << updated;
  EXPECT_EQ(read(folder_.path() / "model.bdf"), deck);

  // Another run of the program takes it up.
  Session again(folder_.path());
  again.take_up(session.saved());
  EXPECT_NEAR(again.ladder().back().error, d.error_best, 0.01 * d.error_best);

  EXPECT_TRUE(session.undo());
  EXPECT_TRUE(session.effects().empty());
  EXPECT_EQ(session.ladder().front().error, session.ladder().back().error);
}

// The deck as written has the floor of another structure, before the number is
// put right as well.
TEST_F(CorrectedDeck, HasTheFloorOfTheDeckPutRight) {
  Session session(folder_.path());
  const double as_written = session.comparison().floor;
  const Diagnosis d = session.diagnosis();
  EXPECT_GT(as_written, 1.2 * d.floor);
  EXPECT_NEAR(session.comparison().floor, d.floor, 1e-3 * d.floor);
  add_ladder(session, d, {});
  EXPECT_NEAR(session.comparison().floor, d.floor, 0.1 * d.floor);
}

TEST_F(CorrectedDeck, TakesWhatIsMissingBesides) {
  Session session(folder_.path());
  session.fit_uncertain();
  session.add_together({{"card-swap", {.variant = "T-times-2"}},
                        {"added-mass", {.node = testing::plate_grid(10, 0)}}});
  const std::vector<Rung>& ladder = session.ladder();
  ASSERT_EQ(ladder.size(), 4U);
  EXPECT_LT(ladder[2].error, 0.1 * ladder[1].error);
  EXPECT_LE(ladder[3].error, 1.001 * ladder[2].error);
  EXPECT_TRUE(ladder[3].parameters.front().at_bound ||
              ladder[3].parameters.front().value <
                  3.0 * ladder[3].parameters.front().sd);
}

}  // namespace
}  // namespace tapfit::updating
