#include "tui/work/next_step.hpp"

#include "tests/tui/support/fake_results.hpp"

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
  EXPECT_EQ(step_words(1, known), "next: 3 identifies the modes");
  known.modes = shared(testing::fake_modes());
  EXPECT_EQ(step_words(2, known), "next: 4 compares them with the model");
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
  c.floor = 1.6;
  known.comparison = shared(c);
  EXPECT_EQ(
      step_words(3, known),
      "next: a floor of 160.0 % hides what is missing: 7 has the warnings");
  known.diagnosis = shared(testing::fake_diagnosis());
  EXPECT_EQ(step_words(4, known),
            "next: A adds what the verdict names, a the marked candidate");
  EXPECT_EQ(step_words(6, known),
            "next: w writes the report, e the deck, f FRFs and modes");
}

TEST(NextStep, EndsWithTheReportWithoutAModel) {
  Snapshot known;
  known.modes = shared(testing::fake_modes());
  EXPECT_EQ(step_words(2, known), "next: w on 7 writes the report");
}

}  // namespace
}  // namespace tapfit::tui
