#include "updating/fit/fit_context.hpp"

#include "tests/updating/support/deck_support.hpp"

#include <gtest/gtest.h>

namespace tapfit::updating {
namespace {

acquisition::TestBundle sensor_at(int grid) {
  acquisition::TestBundle bundle;
  bundle.channels.resize(2);
  bundle.channels[0].name = "hammer";
  bundle.channels[0].quantity = acquisition::Quantity::Force;
  bundle.channels[1].name = "acc1";
  acquisition::Run run;
  run.hammer = {0, {grid, 3, 1}};
  run.sensors = {{1, {grid, 3, 1}}};
  bundle.runs.push_back(run);
  return bundle;
}

TEST(SolveModel, KnowsOfAMeshOnlyWhereThereIsOne) {
  const auto springs = structure::deck_of(
      "BEGIN BULK\n"
      "GRID,1,,0.,0.,0.\n"
      "GRID,2,,0.1,0.,0.\n"
      "CONM2,11,1,,0.5\n"
      "CONM2,12,2,,0.4\n"
      "CELAS2,21,200000.,1,3\n"
      "CELAS2,22,100000.,1,3,2,3\n"
      "SPC1,1,12456,1,2\n"
      "ENDDATA\n");
  const SolvedModel none = solve_model(springs, sensor_at(2), 200.0, {});
  EXPECT_FALSE(none.coarse);
  EXPECT_TRUE(none.corrections.empty());
  const structure::Deck plate = structure::plate_deck({}, 2, 2);
  const SolvedModel meshed = solve_model(plate, sensor_at(1), 200.0, {});
  EXPECT_TRUE(meshed.coarse);
  EXPECT_GE(meshed.corrections.size(), 1U);
}

}  // namespace
}  // namespace tapfit::updating
