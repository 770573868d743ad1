#include "signal/checks/shared_factor.hpp"

#include "signal/checks/frf_findings.hpp"
#include "signal/checks/reciprocity_findings.hpp"
#include "signal/estimate/estimate_frfs.hpp"
#include "tests/signal/support/generated_structure.hpp"

#include <gtest/gtest.h>

namespace tapfit::signal {
namespace {

GeneratedTest three_sensors() {
  const HungStructure structure{
      {{18.0, 0.01, {1.0, -0.7, 0.4}}, {55.0, 0.008, {0.3, 0.8, 0.6}}},
      {0, 1, 2},
      {0, 1, 2}};
  GeneratedOptions o;
  o.hits = 3;
  o.response_noise = 0.02;
  o.force_noise = 0.01;
  o.seed = 21;
  return generate_structure(structure, o);
}

FrfSet frfs_of(const GeneratedTest& test) {
  return estimate_frfs(test.bundle, test.recordings, test.hits, {});
}

std::vector<SharedFactor> factors_of(const GeneratedTest& test) {
  const FrfSet set = frfs_of(test);
  return shared_factors(set, reciprocals(set));
}

void is_second_point(const std::vector<SharedFactor>& found, double factor) {
  ASSERT_EQ(found.size(), 1U);
  EXPECT_EQ(found[0].point.node, 2);
  EXPECT_EQ(found[0].channel, 2U);
  EXPECT_EQ(found[0].run, 1U);
  // The noise of two FRFs of some hundred lines: a tenth of a per cent.
  EXPECT_NEAR(found[0].factor, factor, 0.01 * factor);
  EXPECT_EQ(found[0].pairs.size(), 2U);
}

TEST(SharedFactor, AFairTestHasNone) {
  EXPECT_TRUE(factors_of(three_sensors()).empty());
}

// By definition x_2 = s_2 h_2: a sensor that reads half, a hammer that reads
// twice as much where its point is hit.
TEST(SharedFactor, IsThatOfTheSensorOrOfTheBlow) {
  GeneratedTest test = three_sensors();
  for (auto& recording : test.recordings) recording.samples.col(2) *= 0.5;
  is_second_point(factors_of(test), 0.5);

  test = three_sensors();
  test.recordings[1].samples.col(0) *= 2.0;
  is_second_point(factors_of(test), 2.0);
}

TEST(SharedFactor, IsOneFindingThatNamesBoth) {
  GeneratedTest test = three_sensors();
  for (auto& recording : test.recordings) recording.samples.col(2) *= 0.5;
  const FrfSet set = frfs_of(test);
  const std::vector<Finding> said =
      reciprocity_findings(test.bundle, set, reciprocals(set));
  ASSERT_EQ(said.size(), 1U);
  EXPECT_EQ(said[0].likely,
            "of the sensitivities that of acc2 is off by it, or that of hammer "
            "in run 2");
}

// Two points off at once: each from its path to the third, and what is between
// them is told by both.
TEST(SharedFactor, OfTwoPointsAreTwo) {
  HungStructure structure{{{18.0, 0.01, {1.0, -0.7, 0.4, 0.9}},
                           {55.0, 0.008, {0.3, 0.8, 0.6, -0.5}}},
                          {0, 1, 2, 3},
                          {0, 1, 2, 3}};
  GeneratedOptions o;
  o.hits = 3;
  o.seed = 22;
  GeneratedTest test = generate_structure(structure, o);
  for (auto& recording : test.recordings) {
    recording.samples.col(1) *= 2.0;
    recording.samples.col(2) *= 3.0;
  }
  const std::vector<SharedFactor> found = factors_of(test);
  ASSERT_EQ(found.size(), 2U);
  std::size_t explained = 0;
  for (const SharedFactor& one : found) {
    EXPECT_NEAR(one.factor, one.point.node == 1 ? 2.0 : 3.0, 0.03);
    explained += one.pairs.size();
  }
  EXPECT_EQ(explained, 5U);
}

}  // namespace
}  // namespace tapfit::signal
