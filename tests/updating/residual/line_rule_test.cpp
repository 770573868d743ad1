#include "updating/residual/line_rule.hpp"

#include "acquisition/foundation/input_error.hpp"

#include <gtest/gtest.h>

namespace tapfit::updating {
namespace {

using Eigen::VectorXd;

const VectorXd truss = (VectorXd(2) << 75.68, 140.12).finished();

TEST(LineRuleTest, ListsHoldBothEndsOfARange) {
  const VectorXd lines =
      lines_of(parse_lines("31.5,20,40:41:0.5,20"), {10.0, 100.0}, {});
  const VectorXd expected = (VectorXd(5) << 20, 31.5, 40, 40.5, 41).finished();
  EXPECT_EQ(lines, expected);
}

TEST(LineRuleTest, LinesOutsideTheBandAreLeftOut) {
  const VectorXd lines = lines_of(parse_lines("even:10"), {15.0, 40.0}, {});
  EXPECT_EQ(lines, (VectorXd(3) << 20, 30, 40).finished());
}

// The paper's Case 3 for its truss: 8 lines 0.5 Hz apart from 10 Hz before.
TEST(LineRuleTest, BeforePeaksIsThePapersForItsTruss) {
  const VectorXd lines =
      lines_of(parse_lines("before-peaks"), {1.0, 500.0}, truss);
  ASSERT_EQ(lines.size(), 16);
  EXPECT_NEAR(lines(0), 65.68, 1e-9);
  EXPECT_NEAR(lines(7), 69.18, 1e-9);
  EXPECT_NEAR(lines(8), 130.12, 1e-9);
  EXPECT_NEAR(gaps_of(parse_lines("rule"), truss)->around_hz, 4.0, 1e-9);
  // A structure a tenth as quick has a tenth of the gap; a size given counts.
  EXPECT_NEAR(gaps_of(parse_lines("rule"), 0.1 * truss)->around_hz, 0.4, 1e-9);
  EXPECT_EQ(gaps_of(parse_lines("rule:3"), truss)->around_hz, 3.0);
  EXPECT_FALSE(gaps_of(parse_lines("even"), truss));
}

TEST(LineRuleTest, RandomLinesAreTheSameEveryTime) {
  const LineRule rule = parse_lines("random:20");
  const VectorXd lines = lines_of(rule, {1e-6, 500.0}, {});
  EXPECT_EQ(lines.size(), 20);
  EXPECT_EQ(lines, lines_of(rule, {1e-6, 500.0}, {}));
}

TEST(LineRuleTest, RefusesWhatIsNoLine) {
  for (const char* text : {"",
                           "peaks",
                           "rule:0",
                           "rule:1:2",
                           "random:0.5",
                           "random:1e9",
                           "10,",
                           "10:20",
                           "10:20:0",
                           "20:10:1",
                           "1:1e9:1e-3",
                           "-5",
                           "nan",
                           "inf",
                           "damped:3",
                           "10 20"}) {
    EXPECT_THROW(static_cast<void>(parse_lines(text)), InputError) << text;
  }
}

TEST(LineRuleTest, RefusesLinesThatLeaveNothing) {
  EXPECT_THROW(
      static_cast<void>(lines_of(parse_lines("5"), {10.0, 20.0}, truss)),
      InputError);
  EXPECT_THROW(static_cast<void>(lines_of(
                   parse_lines("before-peaks"), {10.0, 20.0}, VectorXd())),
               InputError);
  EXPECT_THROW(
      static_cast<void>(lines_of(parse_lines("even:1e-6"), {1.0, 2e3}, {})),
      InputError);
}

TEST(LineRuleTest, RefusesBeforeAnythingIsMeasuredWhatNeedsNothing) {
  for (const auto* text : {"5", "even:30", "even:1e-6"}) {
    EXPECT_THROW(check_lines(parse_lines(text), {10.0, 20.0}), InputError)
        << text;
  }
  for (const auto* text : {"15", "even:3", "random", "rule", "before-peaks"}) {
    EXPECT_NO_THROW(check_lines(parse_lines(text), {10.0, 20.0})) << text;
  }
}

}  // namespace
}  // namespace tapfit::updating
