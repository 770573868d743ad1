#include "updating/fit/overall_progress.hpp"

#include "updating/fit/fit_observer.hpp"

#include <gtest/gtest.h>

#include <vector>

namespace tapfit::updating {
namespace {

TEST(OverallProgress, PutsAPartIntoTheWhole) {
  std::vector<double> seen;
  const Progress whole{
      [&seen](std::string_view, double share) { seen.push_back(share); }, {}};
  const Progress part = part_of(part_of(whole, 0.5, 1.0), 0.0, 0.5);
  part("fitting", 0.0);
  part("fitting", 0.5);
  part("fitting", 1.0);
  // Binary fractions: exact.
  EXPECT_EQ(seen, (std::vector<double>{0.5, 0.625, 0.75}));
}

TEST(OverallProgress, NeverFalls) {
  std::vector<double> seen;
  const Progress whole = monotonic(
      {[&seen](std::string_view, double share) { seen.push_back(share); }, {}});
  const Progress copy = whole;
  whole("fitting", 0.5);
  copy("fitting", 0.25);
  whole("fitting", 0.75);
  EXPECT_EQ(seen, (std::vector<double>{0.5, 0.5, 0.75}));
}

TEST(OverallProgress, NumbersStagesFromTheSecondRoundOn) {
  std::vector<std::string> seen;
  const Progress whole{
      [&seen](std::string_view stage, double) { seen.emplace_back(stage); },
      {}};
  numbered(whole, "rung", 1)("screening", 0.5);
  numbered(whole, "rung", 2)("screening", 0.5);
  EXPECT_EQ(seen,
            (std::vector<std::string>{"screening", "screening (rung 2)"}));
}

// A diagnosis fits many hypotheses: who watches one fit does not want them.
TEST(OverallProgress, IsWatchedWhereThatIsAskedFor) {
  FitObserver observer;
  observer.enough = [] { return true; };
  const Progress whole{{}, {}, std::make_shared<const FitObserver>(observer)};
  EXPECT_TRUE(is_enough(observed_part(whole, 0.0, 0.5)));
  EXPECT_FALSE(is_enough(part_of(whole, 0.0, 0.5)));
  EXPECT_FALSE(is_enough(numbered(whole, "rung", 1)));
  EXPECT_FALSE(is_enough(monotonic(whole)));
}

TEST(OverallProgress, StopsAsTheWholeDoes) {
  std::stop_source source;
  const Progress part = part_of(monotonic({{}, source.get_token()}), 0, 1);
  part("fitting", 0.5);
  source.request_stop();
  EXPECT_THROW(part("fitting", 0.5), Stopped);
}

}  // namespace
}  // namespace tapfit::updating
