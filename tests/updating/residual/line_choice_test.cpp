#include "updating/residual/line_choice.hpp"

#include <gtest/gtest.h>

#include <algorithm>

namespace tapfit::updating {
namespace {

using Eigen::VectorXd;

TEST(LineChoiceTest, CasesOfThePaperHaveFortyLinesEach) {
  const VectorXd even = even_lines(400.0, 10.0);
  ASSERT_EQ(even.size(), 40);
  EXPECT_DOUBLE_EQ(even(0), 10.0);
  EXPECT_DOUBLE_EQ(even(39), 400.0);

  acquisition::SeededRandom random(1, "lines");
  const VectorXd scattered = random_lines(400.0, 40, random);
  ASSERT_EQ(scattered.size(), 40);
  EXPECT_TRUE(std::is_sorted(scattered.begin(), scattered.end()));
  EXPECT_GE(scattered.minCoeff(), 0.0);
  EXPECT_LE(scattered.maxCoeff(), 400.0);

  VectorXd peaks(5);
  peaks << 76.0, 140.0, 214.0, 301.0, 361.0;
  const VectorXd before = lines_before_peaks(peaks);
  ASSERT_EQ(before.size(), 40);
  EXPECT_DOUBLE_EQ(before(0), 66.0);
  EXPECT_DOUBLE_EQ(before(7), 69.5);
  EXPECT_DOUBLE_EQ(before(39), 354.5);
}

TEST(LineChoiceTest, RuleLeavesOutPeaksAndWhatLiesBetweenCloseOnes) {
  VectorXd measured(3);
  measured << 50.0, 100.0, 108.0;
  VectorXd model(3);
  model << 53.0, 99.0, 107.0;
  VectorXd lines(9);
  //       free  gap   shift gap   free  gap    close  gap    free
  lines << 40.0, 48.5, 51.5, 54.5, 80.0, 100.5, 103.5, 109.5, 120.0;
  const PeakRule rule{4.0, 10.0};
  EXPECT_EQ(off_peaks(lines, measured, model, rule),
            (std::vector<bool>{
                true, false, false, false, true, false, false, false, true}));
  // Peaks 7 Hz apart are close only where the rule says so.
  EXPECT_TRUE(off_peaks(lines, measured, model, PeakRule{4.0, 5.0})[6]);
}

}  // namespace
}  // namespace tapfit::updating
