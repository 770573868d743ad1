// A channel seen without its drift, against the drift that was put in.
#include "acquisition/samples/baseline_removal.hpp"

#include "acquisition/samples/statistics.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace tapfit::acquisition {
namespace {

using Eigen::Index;

// A ramp with something on it that sums to little in every segment.
Eigen::VectorXd drifting(Index n) {
  Eigen::VectorXd x(n);
  for (Index i = 0; i < n; ++i) {
    const auto t = static_cast<double>(i);
    x[i] = 5.0 + 0.01 * t + 0.2 * std::sin(0.3 * t * t);
  }
  return x;
}

// Between the first segment's middle and the last one's a ramp is taken off
// whole; medians of 300 values of that scatter are good to 0.02.
TEST(BaselineFree, TakesARampOff) {
  const Eigen::VectorXd x = drifting(5000);
  const BaselineFree left(x, 300);
  for (Index i = 200; i < 4800; ++i) {
    const double put_in = x[i] - 5.0 - 0.01 * static_cast<double>(i);
    ASSERT_NEAR(left[i], put_in, 0.1) << i;
  }
}

// Level before the first segment's middle: sample 0 lies half a segment of
// slope 0.01 below.
TEST(BaselineFree, IsLevelAtTheEnds) {
  const Eigen::VectorXd ramp = Eigen::VectorXd::LinSpaced(4000, 0.0, 39.99);
  const BaselineFree left(ramp, 400);
  EXPECT_NEAR(left[0], -0.01 * 200, 0.01);
  EXPECT_NEAR(left[3999], 0.01 * 200, 0.01);
  EXPECT_NEAR(left[2000], 0.0, 0.01);
}

// One by one, by stretches that begin and end anywhere, and thinned.
TEST(BaselineFree, GivesTheSameInEveryWay) {
  for (const Index n : {1, 100, 256, 1000, 4096, 5000}) {
    const Eigen::VectorXd x = drifting(n);
    BaselineFree left(x, 300);
    if (n == 1000) left.turn();
    const Eigen::VectorXd whole = left.segment(0, n);
    for (Index i = 0; i < n; ++i) ASSERT_NEAR(left[i], whole[i], 1e-12) << i;
    for (Index from = 0; from < n; from += 37) {
      const Index count = std::min<Index>(n - from, 2 * from + 1);
      const Eigen::VectorXd part = left.segment(from, count);
      ASSERT_LT((part - whole.segment(from, count)).norm(), 1e-12) << from;
    }
    const Eigen::VectorXd few = left.thinned(64);
    ASSERT_LT((few - thinned(whole, 64)).norm(), 1e-12);
    EXPECT_EQ(left.segment(0, 0).size(), 0);
  }
}

// Around the values, and no farther than a slope of 0.01, or what medians that
// are off by 0.02 make of it, goes in 256 samples.
TEST(BaselineFree, BoundsItsPieces) {
  for (const Index n : {100, 256, 1000, 4096, 5000}) {
    for (const bool turned : {false, true}) {
      const Eigen::VectorXd x = drifting(n);
      BaselineFree left(x, 300);
      if (turned) left.turn();
      const std::vector<Range> exact = piece_ranges(left.segment(0, n));
      const std::vector<Range> pieces = left.pieces();
      ASSERT_EQ(pieces.size(), exact.size());
      for (std::size_t k = 0; k < pieces.size(); ++k) {
        EXPECT_LE(pieces[k].low, exact[k].low + 1e-12);
        EXPECT_GE(pieces[k].high, exact[k].high - 1e-12);
        EXPECT_NEAR(pieces[k].low, exact[k].low, 2.7);
        EXPECT_NEAR(pieces[k].high, exact[k].high, 2.7);
      }
    }
  }
}

TEST(BaselineFree, LeavesPlainValuesAsTheyAre) {
  const Eigen::VectorXd x = drifting(100);
  const BaselineFree same = x;
  EXPECT_EQ(same.segment(0, 100), x);
  EXPECT_EQ(same[99], x[99]);
}

}  // namespace
}  // namespace tapfit::acquisition
