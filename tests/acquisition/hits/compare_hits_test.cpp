#include "acquisition/hits/compare_hits.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace tapfit::acquisition {
namespace {

// Beside 1.6, a second blow of share p excuses factors of 1 - p to 1 + p.
TEST(CompareHits, ASecondBlowExcusesWhatItCanDo) {
  const auto is_out = [](double factor, double second) {
    Eigen::MatrixXd levels = Eigen::MatrixXd::Zero(5, 1);
    levels(4, 0) = std::log(factor);
    return is_outlier(levels.row(4), levels, second);
  };
  for (const double p : {0.0, 0.3, 0.6, 0.9}) {
    EXPECT_FALSE(is_out(1.59 * (1.0 + p), p)) << p;
    EXPECT_TRUE(is_out(1.61 * (1.0 + p), p)) << p;
    EXPECT_FALSE(is_out((1.0 - p) / 1.59, p)) << p;
    EXPECT_TRUE(is_out((1.0 - p) / 1.61, p)) << p;
  }
}

}  // namespace
}  // namespace tapfit::acquisition
