#include "tests/updating/support/sample_plate.hpp"
#include "updating/set_up/mistakes.hpp"

#include <gtest/gtest.h>

namespace tapfit::effects {
namespace {

class Swaps : public ::testing::Test {
 protected:
  // The plate with a third sensor, at grid 55 along X.
  Swaps() {
    acquisition::Channel acc3;
    acc3.name = "acc3";
    written_.channels.push_back(acc3);
    for (acquisition::Run& run : written_.runs) {
      run.sensors.push_back({3, {55, 1, 1}});
    }
    sheet_ = written_;
  }

  void swap(const std::string& a, const std::string& b) {
    channel_swap().correct({.channels = {a, b}}, written_, sheet_);
  }
  [[nodiscard]] Dof at(std::size_t sensor) const {
    return sheet_.runs.at(2).sensors.at(sensor).dof;
  }

  acquisition::TestBundle written_ = support::plate_bundle();
  acquisition::TestBundle sheet_;
};

constexpr Dof of_acc1{11, 3, 1};
constexpr Dof of_acc2{36, 3, -1};
constexpr Dof of_acc3{55, 1, 1};

TEST_F(Swaps, ExchangePointAndDirection) {
  swap("acc1", "acc2");
  EXPECT_EQ(at(0), of_acc2);
  EXPECT_EQ(at(1), of_acc1);
  EXPECT_EQ(at(2), of_acc3);
}

TEST_F(Swaps, OfThreeChannelsGoRound) {
  swap("acc1", "acc2");
  swap("acc2", "acc3");
  EXPECT_EQ(at(0), of_acc2);
  EXPECT_EQ(at(1), of_acc3);
  EXPECT_EQ(at(2), of_acc1);
}

TEST_F(Swaps, TwiceAreNone) {
  swap("acc1", "acc2");
  swap("acc1", "acc2");
  EXPECT_EQ(at(0), of_acc1);
  EXPECT_EQ(at(1), of_acc2);
}

TEST_F(Swaps, KeepWhatWasPutRightBefore) {
  const Location where{.node = 33, .nodes = {36}, .channels = {"acc2"}};
  point_mislabelled().correct(where, written_, sheet_);
  swap("acc1", "acc2");
  EXPECT_EQ(at(0), (Dof{33, 3, -1}));
  EXPECT_EQ(at(1), of_acc1);
}

}  // namespace
}  // namespace tapfit::effects
