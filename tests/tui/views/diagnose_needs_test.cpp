#include "tests/tui/support/fake_results.hpp"
#include "tui/views/diagnose_view.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <memory>

namespace tapfit::tui {
namespace {

// A test of ready FRFs has neither, and can be diagnosed.
TEST(DiagnosePage, AsksForNoRecordings) {
  for (const Need& need : DiagnosePage().essential()) {
    EXPECT_NE(need.stage, Stage::Traces);
    EXPECT_NE(need.stage, Stage::Hits);
  }
}

// What led while candidates were still tried is not what was found.
TEST(DiagnosePage, StandsOnTheVerdictWhereNothingElseWasChosen) {
  auto found = std::make_shared<updating::Diagnosis>(testing::fake_diagnosis());
  auto tried = std::make_shared<updating::Diagnosis>(*found);
  std::ranges::reverse(tried->candidates);
  Snapshot before;
  before.preliminary = tried;
  Snapshot now;
  now.diagnosis = found;
  DiagnosePage page;
  page.follow(before, now);
  EXPECT_EQ(page.list()->selected, 0U);
  page.list()->selected = 1;  // that of the verdict, as it was listed
  page.follow(before, now);
  EXPECT_EQ(page.list()->selected, 0U);
  page.list()->selected = 1;
  page.follow(now, before);
  EXPECT_EQ(page.list()->selected, 0U);
}

// Lists that are made on the way come without it, and with others first.
TEST(DiagnosePage, ComesBackToWhatWasChosenOnceItIsListed) {
  const auto listed = [](std::vector<std::size_t> rows) {
    const updating::Diagnosis all = testing::fake_diagnosis();
    auto some = std::make_shared<updating::Diagnosis>(all);
    some->candidates.clear();
    for (const std::size_t row : rows) {
      some->candidates.push_back(all.candidates[row]);
    }
    return some;
  };
  Snapshot last;
  last.diagnosis = listed({0, 1});
  DiagnosePage page;
  Command command;
  ASSERT_TRUE(page.press(last, Key(U'j'), command));
  Snapshot tried;
  tried.preliminary = listed({0});
  page.follow(last, tried);
  for (const char32_t key : {U'a', U't', U'i'}) {
    command = {};
    EXPECT_TRUE(page.press(tried, Key(key), command));
    EXPECT_EQ(command.kind, Command::Kind::None);
    EXPECT_NE(command.message.find("sensor-mass at acc1 is not tried yet"),
              std::string::npos)
        << command.message;
  }
  Snapshot more;
  more.preliminary = listed({1, 0});  // the first, which somebody did choose
  page.follow(tried, more);
  Snapshot verdict;
  verdict.diagnosis = listed({0, 1});
  page.follow(more, verdict);
  command = {};
  EXPECT_TRUE(page.press(verdict, Key(U'a'), command));
  ASSERT_EQ(command.effects.size(), 1U);
  EXPECT_EQ(command.effects[0].effect, "sensor-mass");
  // Once added it need not be listed any more.
  Snapshot without;
  without.diagnosis = listed({0});
  without.effects = {{command.effects[0], true}};
  page.follow(verdict, without);
  command = {};
  EXPECT_TRUE(page.press(without, Key(U'a'), command));
  ASSERT_EQ(command.effects.size(), 1U);
  EXPECT_EQ(command.effects[0].effect, "added-mass");
}

// Of sensors there is no signature to go to and back from.
TEST(DiagnosePage, OffersTheOtherPlotOnlyWhereThereIsOne) {
  Snapshot known;
  known.bundle =
      std::make_shared<acquisition::TestBundle>(testing::fake_bundle());
  updating::Diagnosis d = testing::fake_diagnosis();
  d.candidates[1].where.channels = {"acc1", "acc2"};
  known.diagnosis = std::make_shared<updating::Diagnosis>(d);
  known.frfs = std::make_shared<signal::FrfSet>(testing::fake_frfs());
  DiagnosePage page;
  const auto offered = [&] {
    const auto keys = page.keys(known);
    const auto e = std::ranges::find(keys, "e", &KeyHelp::key);
    return e == keys.end() ? std::string() : e->what;
  };
  EXPECT_EQ(offered(), "with/without");
  Command command;
  ASSERT_TRUE(page.press(known, Key(U'e'), command));
  EXPECT_EQ(offered(), "signature");
  ASSERT_TRUE(page.press(known, Key(U'e'), command));
  ASSERT_TRUE(page.press(known, Key(U'j'), command));
  EXPECT_EQ(offered(), "");
  ASSERT_TRUE(page.press(known, Key(U'e'), command));
  EXPECT_EQ(command.message, "of this there are only FRFs with and without it");
  ASSERT_TRUE(page.press(known, Key(U'k'), command));
  EXPECT_EQ(offered(), "with/without") << "nothing was switched";
}

TEST(DiagnosePage, GoesElsewhereFromWhatIsNotListed) {
  Snapshot last;
  last.diagnosis =
      std::make_shared<updating::Diagnosis>(testing::fake_diagnosis());
  DiagnosePage page;
  Command command;
  ASSERT_TRUE(page.press(last, Key(U'j'), command));
  auto one = std::make_shared<updating::Diagnosis>(*last.diagnosis);
  one->candidates.pop_back();
  Snapshot tried;
  tried.preliminary = one;
  page.follow(last, tried);
  ASSERT_TRUE(page.press(tried, Key(U'j'), command));
  page.follow(tried, last);
  EXPECT_EQ(page.list()->selected, 0U);
  EXPECT_TRUE(page.press(last, Key(U'a'), command));
  EXPECT_EQ(command.effects[0].effect, "added-mass");
}

}  // namespace
}  // namespace tapfit::tui
