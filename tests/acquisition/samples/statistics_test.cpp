// What is taken from a record to know its level, against the definitions.
#include "acquisition/samples/statistics.hpp"

#include <gtest/gtest.h>

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

}  // namespace
}  // namespace tapfit::acquisition
