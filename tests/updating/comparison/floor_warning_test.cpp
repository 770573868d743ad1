#include "updating/comparison/compare.hpp"

#include <gtest/gtest.h>

namespace tapfit::updating {
namespace {

TEST(FloorWarning, NamesWhatMakesTheFloorHigh) {
  Comparison c;
  c.floor = c.floor_noise = 0.4;
  EXPECT_NE(floor_warning(c).find("measure again"), std::string::npos);
  c.floor_noise = 0.1;
  c.floor_mesh = 0.39;
  EXPECT_NE(floor_warning(c).find("refine the model"), std::string::npos);
  c.floor = 0.2;
  EXPECT_EQ(floor_warning(c), "");
}

}  // namespace
}  // namespace tapfit::updating
