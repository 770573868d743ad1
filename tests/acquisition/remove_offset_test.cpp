// What is taken from a record to know its level, against the definitions.
#include "acquisition/remove_offset.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace tapfit::acquisition {
namespace {

using Eigen::Index;

// Part k of m holds the samples [k n / m, (k + 1) n / m); the one at 7919 k
// modulo its length is taken. Lengths that m divides, and does not.
TEST(Thinned, TakesOneSampleOfEachPart) {
  for (const Index n : {10, 512, 513, 1000, 25600, 81649}) {
    const Eigen::VectorXd x =
        Eigen::VectorXd::LinSpaced(n, 0.0, static_cast<double>(n - 1));
    for (const Index most : {7, 512, 4096}) {
      const Eigen::VectorXd taken = thinned(x, most);
      ASSERT_EQ(taken.size(), std::min(n, most));
      for (Index k = 0; k < taken.size(); ++k) {
        if (n <= most) break;
        const Index from = k * n / most;
        const Index part = (k + 1) * n / most - from;
        ASSERT_EQ(taken[k], static_cast<double>(from + (7919 * k) % part))
            << k << " of " << n << " in " << most;
      }
    }
  }
}

TEST(WithoutDrift, GivesTheRangesOfWhatItLeaves) {
  for (const Index n : {100, 256, 1000, 4096, 5000}) {
    Eigen::VectorXd x(n);
    for (Index i = 0; i < n; ++i) {
      const auto t = static_cast<double>(i);
      x[i] = 0.01 * t + std::sin(0.3 * t * t);
    }
    const Driftless left = without_drift(x, 300);
    const std::vector<Range> pieces = piece_ranges(left.values);
    ASSERT_EQ(left.pieces.size(), pieces.size());
    for (std::size_t k = 0; k < pieces.size(); ++k) {
      EXPECT_EQ(left.pieces[k].low, pieces[k].low);
      EXPECT_EQ(left.pieces[k].high, pieces[k].high);
    }
    EXPECT_EQ(joined(pieces).high, left.values.maxCoeff());
    EXPECT_EQ(joined(pieces).low, left.values.minCoeff());
  }
}

}  // namespace
}  // namespace tapfit::acquisition
