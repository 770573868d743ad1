#include "updating/fit/fit_context.hpp"

#include "tests/updating/support/deck_support.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <string>

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

// A cantilever of many bars, and a brick.
std::string row_of_bars(int bars) {
  std::string text =
      "BEGIN BULK\n"
      "MAT1,1,70.+9,,.3,2700.\n"
      "PBAR,1,1,1.-4,1.-9,1.-9,1.-9\n"
      "SPC1,1,123456,1\n";
  for (int k = 0; k <= bars; ++k) {
    text += fmt::format("GRID,{},,{:.4f},0.,0.\n", k + 1, 0.001 * k);
  }
  for (int k = 1; k <= bars; ++k) {
    text += fmt::format("CBAR,{},1,{},{},0.,0.,1.\n", k, k, k + 1);
  }
  return text + "ENDDATA\n";
}

constexpr const char* brick =
    "BEGIN BULK\n"
    "MAT1,1,70.+9,,.3,2700.\n"
    "PSOLID,1,1\n"
    "GRID,1,,0.,0.,0.\n"
    "GRID,2,,1.,0.,0.\n"
    "GRID,3,,1.,1.,0.\n"
    "GRID,4,,0.,1.,0.\n"
    "GRID,5,,0.,0.,1.\n"
    "GRID,6,,1.,0.,1.\n"
    "GRID,7,,1.,1.,1.\n"
    "GRID,8,,0.,1.,1.\n"
    "CHEXA,1,1,1,2,3,4,5,6\n"
    ",7,8\n"
    "SPC1,1,123,1,2,3,4\n"
    "ENDDATA\n";

TEST(SolveModel, SaysWhereTheMeshLeavesWhatIsNotKnown) {
  const auto said = [](const structure::Deck& deck, int grid, double high_hz) {
    return mesh_warning(solve_model(deck, sensor_at(grid), high_hz, {}));
  };
  EXPECT_EQ(said(structure::plate_deck({}, 2, 2), 1, 200.0), "");
  EXPECT_EQ(said(structure::deck_of(row_of_bars(100)), 101, 2000.0), "");
  EXPECT_NE(said(structure::deck_of(row_of_bars(3000)), 3001, 10.0)
                .find("up to 3000 grids, and the model has 3001"),
            std::string::npos);
  EXPECT_NE(said(structure::deck_of(brick), 7, 2000.0)
                .find("solids and quadratic shells are not split"),
            std::string::npos);
}

}  // namespace
}  // namespace tapfit::updating
