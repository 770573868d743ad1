// Structures of all positive shapes at the points: every FRF looks like one of
// a driving point, so that only reciprocity tells what was exchanged.
#include "signal/checks/exchanged_labels.hpp"

#include "signal/estimate/estimate_frfs.hpp"
#include "tests/signal/support/generated_structure.hpp"

#include <gtest/gtest.h>

namespace tapfit::signal {
namespace {

// Held: points 1 to 5 move the same way in both modes.
HungStructure one_way(std::size_t sensors) {
  HungStructure structure{{{18.0, 0.01, {1.0, 0.7, 0.4, 0.9, 0.5}},
                           {55.0, 0.008, {0.3, 0.8, 0.6, 0.5, 0.9}}},
                          {},
                          {0, 1, 2, 3}};
  for (std::size_t at = 0; at < sensors; ++at) structure.sensors.push_back(at);
  return structure;
}

GeneratedTest measured(std::size_t sensors) {
  GeneratedOptions o;
  o.hits = 3;
  o.response_noise = 0.02;
  o.force_noise = 0.01;
  o.seed = 11;
  return generate_structure(one_way(sensors), o);
}

// Written down at point 2.
GeneratedTest with_second_sensor_at(std::size_t point) {
  HungStructure structure = one_way(3);
  structure.sensors[1] = point;
  GeneratedOptions o;
  o.hits = 3;
  o.seed = 12;
  GeneratedTest test = generate_structure(structure, o);
  for (auto& run : test.bundle.runs) run.sensors[1].dof.node = 2;
  return test;
}

std::vector<Finding> found(const GeneratedTest& test) {
  const FrfSet set = estimate_frfs(test.bundle, test.recordings, test.hits, {});
  const std::vector<Reciprocal> pairs = reciprocals(set);
  EXPECT_FALSE(pairs.empty());
  for (const DrivingPoint& point : driving_points(set)) {
    EXPECT_TRUE(point.fair());
  }
  return exchange_findings(
      test.bundle, set, pairs, exchanged_labels(set, pairs));
}

void exchange_sensors(GeneratedTest& test) {
  for (auto& recording : test.recordings) {
    recording.samples.col(1).swap(recording.samples.col(2));
  }
}

TEST(ExchangedLabels, AFairTestHasNone) {
  EXPECT_TRUE(found(measured(2)).empty());
  EXPECT_TRUE(found(measured(3)).empty());
}

// What acc1 and acc2 recorded is that of points called by each other's names,
// if the blows are called so as well: symmetric again.
TEST(ExchangedLabels, SensorsExchangedAreLikeBlowsExchanged) {
  for (const std::size_t sensors : {2U, 3U}) {
    GeneratedTest test = measured(sensors);
    exchange_sensors(test);
    const std::vector<Finding> said = found(test);
    ASSERT_EQ(said.size(), 1U);
    EXPECT_EQ(
        said[0].likely,
        "acc1 and acc2 are swapped, or runs 1 and 2 hit another point than "
        "written down, each the other's");
  }
}

TEST(ExchangedLabels, BlowsExchangedAreLikeASensorMoved) {
  const std::string likely =
      "runs 2 and 4 hit another point than written down, each the other's, "
      "or acc2 sat where run ";
  GeneratedTest test = measured(3);
  std::swap(test.bundle.runs[1].hammer, test.bundle.runs[3].hammer);
  const std::vector<Finding> blows = found(test);
  ASSERT_EQ(blows.size(), 1U);
  // As the sheet has it: run 2 at point 4.
  EXPECT_EQ(blows[0].likely, likely + "2 hit");
  EXPECT_EQ(blows[0].where.runs, (std::vector<std::size_t>{1, 3}));

  const std::vector<Finding> moved = found(with_second_sensor_at(3));
  ASSERT_EQ(moved.size(), 1U);
  EXPECT_EQ(moved[0].likely, likely + "4 hit");
}

// A sensitivity that is off as well is another finding's.
TEST(ExchangedLabels, HoldWhateverTheSensitivities) {
  GeneratedTest test = measured(3);
  exchange_sensors(test);
  for (auto& recording : test.recordings) recording.samples.col(3) *= 1.3;
  const std::vector<Finding> said = found(test);
  ASSERT_EQ(said.size(), 1U);
  EXPECT_TRUE(said[0].likely.starts_with("acc1 and acc2 are swapped"));
}

// No exchange puts right what sat where nobody hit.
TEST(ExchangedLabels, ASensorElsewhereIsNone) {
  EXPECT_TRUE(found(with_second_sensor_at(4)).empty());
}

}  // namespace
}  // namespace tapfit::signal
