#include "acquisition/bundle/runs_alike.hpp"

#include <gtest/gtest.h>

namespace tapfit::acquisition {
namespace {

acquisition::Run run_at(Dof hammer, std::vector<Placement> sensors) {
  acquisition::Run run;
  run.hammer = {0, hammer};
  run.sensors = std::move(sensors);
  return run;
}

// What counts is where and with what, sign and all; not the order of the list.
TEST(RunsAlike, AreThoseOfOnePlacement) {
  const Placement one{1, {3, 3, 1}};
  const Placement two{2, {7, 3, 1}};
  TestBundle bundle;
  bundle.runs = {run_at({3, 3, 1}, {one, two}),
                 run_at({4, 3, 1}, {one, two}),   // another point hit
                 run_at({3, 3, 1}, {two, one}),   // as the first
                 run_at({3, 3, -1}, {one, two}),  // from the other side
                 run_at({3, 3, 1}, {one}),        // a sensor less
                 run_at({3, 3, 1}, {{1, two.dof}, {2, one.dof}}),  // swapped
                 run_at({4, 3, 1}, {one, two})};  // as the second
  const std::vector<RunGroup> groups = runs_alike(bundle);
  const std::vector<RunGroup> expected{{0, 2}, {1, 6}, {3}, {4}, {5}};
  EXPECT_EQ(groups, expected);
  EXPECT_EQ(group_of(groups, 6), 1U);
}

TEST(RunsAlike, ArrangeTheirSensorsAsAnother) {
  const Placement one{1, {3, 3, 1}};
  const Placement two{2, {7, 3, 1}};
  acquisition::Run other = run_at({3, 3, 1}, {two, one});
  other.file = "second.wav";
  const acquisition::Run arranged =
      arranged_as(run_at({3, 3, 1}, {one, two}), other);
  EXPECT_EQ(arranged.file, "second.wav");
  EXPECT_EQ(arranged.sensors.at(0).channel, 1U);
  EXPECT_EQ(arranged.sensors.at(1).channel, 2U);
}

}  // namespace
}  // namespace tapfit::acquisition
