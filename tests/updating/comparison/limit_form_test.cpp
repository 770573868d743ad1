#include "updating/comparison/compare.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace tapfit::updating {
namespace {

// What is missing from a model looks like a form that is far off.
TEST(LimitForm, AllowsNoMoreThanTheBestModelLeaves) {
  Comparison c;
  c.floor_noise = 0.003;
  c.floor_mesh = 0.004;
  c.floor_form = 0.022;
  c.floor = std::hypot(c.floor_noise, c.floor_mesh, c.floor_form);
  const Comparison own = c;
  limit_form(c, 0.03);
  EXPECT_DOUBLE_EQ(c.floor, own.floor);
  limit_form(c, 0.0);
  EXPECT_DOUBLE_EQ(c.floor_form, 0.0);
  EXPECT_DOUBLE_EQ(c.floor, 0.005);
}

}  // namespace
}  // namespace tapfit::updating
