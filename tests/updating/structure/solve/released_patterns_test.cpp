#include "updating/structure/solve/released_patterns.hpp"

#include <Eigen/Dense>
#include <gtest/gtest.h>

#include <cmath>
#include <random>

namespace tapfit::structure {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;

// An edge of a plate that turns: neighbours hold each other, turning all at
// once strains little, and it has hardly any inertia. Driven smoothly, as modes
// do.
class ReleasedEdge : public ::testing::Test {
 protected:
  static constexpr Index grids = 200;
  ReleasedEdge() {
    edge_.top = 1e6;
    edge_.K = MatrixXd::Zero(grids, grids);
    for (Index k = 0; k < grids; ++k) {
      edge_.K(k, k) = 1e3;
      for (const Index other : {k - 1, k + 1}) {
        if (other < 0 || other >= grids) continue;
        edge_.K(k, k) += 1e6;
        edge_.K(k, other) -= 1e6;
      }
    }
    edge_.M = 1e-3 * MatrixXd::Identity(grids, grids);
    std::mt19937 random(5);
    std::normal_distribution<double> normal;
    edge_.loads = MatrixXd::Zero(grids, 20);
    for (Index c = 0; c < edge_.loads.cols(); ++c) {
      for (int wave = 1; wave < 12; ++wave) {
        const double size = 30.0 * normal(random) / wave;
        for (Index k = 0; k < grids; ++k) {
          const double along = (static_cast<double>(k) + 0.5) / grids;
          edge_.loads(k, c) += size * std::sin(M_PI * wave * along);
        }
      }
    }
    springs_ = {{MatrixXd::Identity(grids, grids), 1e1, 1e8}};
  }

  ReleasedMotions edge_;
  std::vector<ReleasedSprings> springs_;
};

// Between the sizes and shifts that it was made of, too.
TEST_F(ReleasedEdge, AnswersAsAllOfIt) {
  const MatrixXd B = released_patterns(edge_, springs_);
  EXPECT_LT(B.cols(), grids / 3);
  for (const double p : {0.0, 3e1, 1e3, 7e4, 3e6, 9e7}) {
    for (const double mu : {0.0, 0.2e6, 0.8e6}) {
      const MatrixXd A = edge_.K + p * springs_[0].S - mu * edge_.M;
      const MatrixXd whole = A.partialPivLu().solve(edge_.loads);
      const MatrixXd few = B * (B.transpose() * A * B)
                                   .partialPivLu()
                                   .solve(B.transpose() * edge_.loads);
      EXPECT_LT((few - whole).norm(), 1e-3 * whole.norm()) << p << ' ' << mu;
    }
  }
}

TEST_F(ReleasedEdge, TakesNothingWhereNothingIsDriven) {
  edge_.loads.setZero();
  EXPECT_EQ(released_patterns(edge_, springs_).cols(), 0);
}

}  // namespace
}  // namespace tapfit::structure
