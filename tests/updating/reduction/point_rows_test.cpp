#include "updating/reduction/point_rows.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace tapfit::updating {
namespace {

using Eigen::MatrixXd;

TEST(PointRows, AreTheColumnsInOtherCoordinates) {
  // Over more rows than are worked out at a time.
  const MatrixXd shared = MatrixXd::Random(1200, 3);
  const MatrixXd own = MatrixXd::Random(1200, 2).cast<float>().cast<double>();
  const MatrixXd first = MatrixXd::Random(3, 3);
  const MatrixXd second = MatrixXd::Random(5, 4);
  PointRows rows(shared);
  rows.turn(first);
  PointRows wider = rows.with(own);
  wider.turn(second);
  MatrixXd both(1200, 5);
  both << shared * first, own;
  const MatrixXd expected = both * second;
  EXPECT_EQ(wider.rows(), 1200);
  EXPECT_EQ(wider.cols(), 4);
  EXPECT_LT((wider.all() - expected).norm(), 1e-12);
  EXPECT_LT((wider.row(700) - expected.row(700)).norm(), 1e-13);
  EXPECT_LT((wider.rows_of_grid(150) - expected.middleRows(900, 6)).norm(),
            1e-13);
  const MatrixXd X = MatrixXd::Random(4, 6);
  EXPECT_LT((wider * X - expected * X).norm(), 1e-12);
  // What was made wider is as it was.
  EXPECT_LT((rows.all() - shared * first).norm(), 1e-12);
}

// Half a unit in the last of 24 bits.
TEST(PointRows, RoundsColumnsThatAreItsOwn) {
  const MatrixXd own = MatrixXd::Random(12, 2);
  const PointRows rows = PointRows(MatrixXd(12, 0)).with(own);
  const double largest =
      ((rows.all() - own).array() / own.array()).abs().maxCoeff();
  EXPECT_LE(largest, std::ldexp(1.0, -24));
  EXPECT_GT(largest, 0.0);
}

// Rows that are not kept are those of the columns made again, once.
TEST(PointRows, KeepsOnlyWhatIsAskedFor) {
  const MatrixXd shared = MatrixXd::Random(24, 3);
  const MatrixXd own = MatrixXd::Random(24, 2);
  const PointRows all = PointRows(shared).with(own);
  PointRows few = all;
  int made = 0;
  few.keep_only({2, 7}, [&] {
    ++made;
    return own;
  });
  EXPECT_EQ(few.own_numbers(), 4);
  EXPECT_EQ(all.own_numbers(), 48);
  EXPECT_EQ(few.row(2), all.row(2));
  EXPECT_EQ(few.row(7), all.row(7));
  EXPECT_EQ(made, 0);
  EXPECT_EQ(few.row(3), all.row(3));
  EXPECT_EQ(few.all(), all.all());
  EXPECT_EQ(few.rows_of_grid(2), all.rows_of_grid(2));
  EXPECT_EQ(made, 1);
}

TEST(PointRows, OfWhatIsAtRestAreZero) {
  const MatrixXd columns = MatrixXd::Random(12, 3);
  PointRows rows(columns);
  rows.set_at_rest({7, 2, 40});  // of a mesh with more grids
  MatrixXd expected = columns;
  expected.row(2).setZero();
  expected.row(7).setZero();
  EXPECT_EQ(rows.all(), expected);
  EXPECT_EQ(rows.rows_of_grid(1), expected.bottomRows(6));
  EXPECT_TRUE(rows.row(7).isZero(0.0));
  EXPECT_EQ(rows.row(8), expected.row(8));
}

}  // namespace
}  // namespace tapfit::updating
