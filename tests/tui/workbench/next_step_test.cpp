#include "tui/workbench/next_step.hpp"

#include "tests/tui/support/fake_results.hpp"
#include "tui/screen/text.hpp"

#include <gtest/gtest.h>

#include <memory>

namespace tapfit::tui {
namespace {

template <class T>
std::shared_ptr<const T> shared(T value) {
  return std::make_shared<const T>(std::move(value));
}

TEST(NextStep, IsSaidFromTheStateOfTheWork) {
  Snapshot known;
  known.has_model = true;
  for (std::size_t screen = 0; screen < 7; ++screen) {
    EXPECT_EQ(step_words(screen, known), "") << screen;
  }
  known.hits = shared(testing::fake_hits());
  EXPECT_EQ(step_words(0, known),
            "next: 2 of 6 hits are rejected: N goes to them, 2 shows the FRFs");
  acquisition::HitSet one = testing::fake_hits();
  for (auto& run : one.runs) {
    for (acquisition::Hit& hit : run) hit.accepted = true;
  }
  one.runs.front().front().accepted = false;
  known.hits = shared(one);
  EXPECT_EQ(step_words(0, known),
            "next: 1 of 6 hits is rejected: N goes to it, 2 shows the FRFs");
  known.frfs = shared(testing::fake_frfs());
  EXPECT_TRUE(step_words(1, known).starts_with("next: coherence 0.9"))
      << step_words(1, known);
  EXPECT_TRUE(step_words(1, known).ends_with(": 3 identifies the modes"));
  known.modes = shared(testing::fake_modes());
  EXPECT_TRUE(step_words(2, known).starts_with("next: 3 modes leave "))
      << step_words(2, known);
  EXPECT_TRUE(step_words(2, known).ends_with(": 4 compares with the model"));
  updating::Comparison c = testing::fake_comparison(0.0);
  c.error = 0.147;
  c.floor = 0.0133;
  known.comparison = shared(c);
  EXPECT_EQ(step_words(3, known),
            "next: 14.7 % is 11 times the floor: 5 shows what is missing");
  known.effects = {{{"added-mass", {}}, true}};
  EXPECT_EQ(step_words(5, known),
            "next: 14.7 % is 11 times the floor: 5 shows what else is missing");
  c.error = 0.0036;
  known.comparison = shared(c);
  EXPECT_EQ(step_words(5, known),
            "next: 0.36 % is within the floor: 7 reports it");
  c.error = 0.0186;
  c.floor = 0.0157;
  known.comparison = shared(c);
  EXPECT_EQ(step_words(5, known),
            "next: 1.9 % is 1.2 times the floor, as good as the data allow: 7 "
            "reports it");
  c.floor = 1.6;
  known.comparison = shared(c);
  EXPECT_EQ(
      step_words(3, known),
      "next: a floor of 160.0 % hides what is missing: 7 has the warnings");
}

TEST(NextStep, CountsNoCoherenceOfASingleHit) {
  Snapshot known;
  signal::FrfSet frfs = testing::fake_frfs();
  frfs.frfs[0].coherence.setOnes();
  frfs.frfs[0].hits = 1;
  known.frfs = shared(frfs);
  EXPECT_EQ(step_words(1, known),
            "next: coherence 0.987 on average, 0.987 at worst: 3 identifies "
            "the modes");
}

TEST(NextStep, SaysWhatTheVerdictBuys) {
  Snapshot known;
  known.has_model = true;
  updating::Diagnosis d = testing::fake_diagnosis();
  d.error_base = 0.807;
  d.ladder = {{"sensor-mass", {}, 0.145, {}}};
  known.diagnosis = shared(d);
  EXPECT_EQ(step_words(4, known),
            "next: sensor-mass takes 80.7 % down to 14.5 %: A adds it");
  d.ladder.push_back({"soft-support", {}, 0.0037, {}});
  known.diagnosis = shared(d);
  EXPECT_EQ(step_words(4, known),
            "next: 2 effects take 80.7 % down to 0.37 %: A adds them all");
  d.ladder.clear();
  d.verdict = "none";
  known.diagnosis = shared(d);
  EXPECT_EQ(step_words(4, known),
            "next: nothing significant is missing: 7 reports it");
  d.verdict = "unexplained";
  known.diagnosis = shared(d);
  EXPECT_EQ(step_words(4, known),
            "next: no effect of the list explains it: i says what may");
}

// 72.6 % at a floor of 46.4 % is no verdict, and no effect supported is not
// nothing missing.
TEST(NextStep, SaysWhatAFloorHides) {
  Snapshot known;
  known.has_model = true;
  updating::Diagnosis d = testing::fake_diagnosis();
  d.ladder.clear();
  d.verdict = "none";
  d.error_best = 0.726;
  d.floor = 0.464;
  known.diagnosis = shared(d);
  updating::Comparison c = testing::fake_comparison(0.0);
  c.error = 0.726;
  c.floor = 0.464;
  known.comparison = shared(c);
  known.base_comparison = shared(c);
  EXPECT_EQ(step_words(4, known),
            "next: a floor of 46.4 % hides what is missing: 7 has the "
            "warnings");
  EXPECT_EQ(step_words(6, known),
            "next: a floor of 46.4 % hides what is missing: w writes the "
            "report");
  d.error_best = 0.05;
  d.floor = 0.01;
  known.diagnosis = shared(d);
  EXPECT_EQ(step_words(4, known),
            "next: no effect is supported by the data: 7 reports it");
}

TEST(NextStep, OfGivenModesSpeaksOfNoFrfs) {
  Snapshot known;
  known.has_model = true;
  acquisition::TestBundle bundle = testing::fake_bundle();
  bundle.modes.emplace();
  known.bundle = shared(bundle);
  known.modes = shared(testing::fake_modes());
  EXPECT_EQ(step_words(2, known),
            "next: 3 modes were given: 4 compares with the model");
}

TEST(NextStep, ReportsOnceItWasLookedFor) {
  Snapshot known;
  known.has_model = true;
  updating::Comparison c = testing::fake_comparison(0.0);
  c.error = 0.807;
  c.floor = 0.013;
  known.base_comparison = shared(c);
  known.comparison = shared(c);
  EXPECT_EQ(step_words(6, known),
            "next: 80.7 % is 62 times the floor: 5 shows what is missing");
  known.effects = {{{"added-mass", {}}, true}};
  c.error = 0.0037;
  known.comparison = shared(c);
  EXPECT_EQ(step_words(6, known),
            "next: error 80.7 % → 0.37 %, floor 1.3 %: w writes the report");
  known.effects.clear();
  EXPECT_EQ(step_words(6, known),
            "next: error 0.37 %, floor 1.3 %: w writes the report");
}

// What the report then holds is not what the screen's model is.
TEST(NextStep, SaysThatTheReportTakesUpTheVerdict) {
  Snapshot known;
  known.has_model = true;
  updating::Comparison c = testing::fake_comparison(0.0);
  c.error = 0.807;
  c.floor = 0.013;
  known.base_comparison = shared(c);
  known.comparison = shared(c);
  updating::Diagnosis d = testing::fake_diagnosis();
  d.error_base = 0.807;
  d.ladder = {{"sensor-mass", {}, 0.145, {}}, {"soft-support", {}, 0.0037, {}}};
  known.diagnosis = shared(d);
  EXPECT_EQ(step_words(6, known),
            "next: w writes the report with the verdict in it: 80.7 % → "
            "0.37 %");
  known.effects = {{{"sensor-mass", {}}, true}};
  EXPECT_TRUE(step_words(6, known).starts_with("next: error 80.7 %"));
}

TEST(NextStep, EndsWithTheReportWithoutAModel) {
  Snapshot known;
  known.bundle = shared(testing::fake_bundle());
  EXPECT_EQ(step_words(3, known),
            "next: no model to compare with: 3 identifies the modes");
  known.modes = shared(testing::fake_modes());
  EXPECT_TRUE(step_words(2, known).ends_with(": w on 7 writes the report"));
  for (std::size_t screen = 3; screen < 6; ++screen) {
    EXPECT_EQ(step_words(screen, known),
              "next: without a model the work ends with the modes: 7 reports "
              "them");
  }
  EXPECT_EQ(step_words(6, known),
            "next: without a model the work ends with the modes: w writes the "
            "report");
}

// A window of 80 columns has room for it.
TEST(NextStep, FitsItsLine) {
  Snapshot known;
  known.has_model = true;
  known.hits = shared(testing::fake_hits());
  known.frfs = shared(testing::fake_frfs());
  known.modes = shared(testing::fake_modes());
  known.comparison = shared(testing::fake_comparison(0.05));
  known.diagnosis = shared(testing::fake_diagnosis());
  for (std::size_t screen = 0; screen < 7; ++screen) {
    EXPECT_LE(text_width(step_words(screen, known)), 78) << screen;
    EXPECT_NE(step_words(screen, known), "") << screen;
  }
  known.modes = shared(modal::ModeSet{});
  EXPECT_LE(text_width(step_words(2, known)), 78) << step_words(2, known);
}

}  // namespace
}  // namespace tapfit::tui
