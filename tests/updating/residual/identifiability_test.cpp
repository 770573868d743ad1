#include "updating/residual/identifiability.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace tapfit::updating {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;

// Columns: a, b, a + b in other units, nothing.
MatrixXd confused() {
  MatrixXd S(4, 4);
  S.setZero();
  S.col(0) << 1.0, 0.0, 0.0, 1.0;
  S.col(1) << 0.0, 2.0, 0.0, 0.0;
  S.col(2) = 1e3 * (S.col(0) + S.col(1));
  return S;
}

TEST(IdentifiabilityTest, NamesWhatCannotBeToldApart) {
  const Identifiability result = identifiability(confused());
  ASSERT_EQ(result.confounded.size(), 2u);
  std::vector<std::vector<Index>> found = result.confounded;
  std::sort(found.begin(), found.end());
  EXPECT_EQ(found[0], (std::vector<Index>{0, 1, 2}));
  EXPECT_EQ(found[1], (std::vector<Index>{3}));
}

TEST(IdentifiabilityTest, SaysNothingOfIndependentParameters) {
  const Identifiability result = identifiability(confused().leftCols(2));
  EXPECT_TRUE(result.confounded.empty());
  // Orthogonal columns: no correlation, both of length 1 when scaled.
  EXPECT_LT((result.correlation - MatrixXd::Identity(2, 2)).norm(), 1e-14);
  EXPECT_NEAR(result.singular_values(0), 1.0, 1e-14);
  EXPECT_NEAR(result.singular_values(1), 1.0, 1e-14);
}

TEST(IdentifiabilityTest, CorrelationIsThatOfTheEstimates) {
  MatrixXd S(3, 2);
  S << 1.0, 1.0, 0.0, 1.0, 0.0, 0.0;
  // (S'S)^-1 = [2 -1; -1 1]: correlation -1 / sqrt(2).
  EXPECT_NEAR(
      identifiability(S).correlation(0, 1), -1.0 / std::sqrt(2.0), 1e-14);
}

}  // namespace
}  // namespace tapfit::updating
