#include "updating/measurement/frf_runs.hpp"

#include <gtest/gtest.h>

namespace tapfit::updating {
namespace {

signal::Frf frf(const Dof& response, const Dof& reference) {
  signal::Frf result;
  result.response = response;
  result.reference = reference;
  return result;
}

TEST(FrfRuns, EachReferenceIsARunAndEachResponseAChannel) {
  signal::FrfSet set;
  set.frfs = {frf({12, 3, 1}, {3, 3, 1}),
              frf({40, 1, -1}, {3, 3, 1}),
              frf({12, 3, 1}, {7, 3, -1})};
  acquisition::TestBundle bundle;
  lay_out_runs(set, bundle, Sensors::Stayed);
  ASSERT_EQ(bundle.channels.size(), 3U);
  EXPECT_EQ(bundle.channels[0].quantity, acquisition::Quantity::Force);
  EXPECT_EQ(bundle.channels[1].name, "12Z");
  EXPECT_EQ(bundle.channels[2].name, "40X");
  ASSERT_EQ(bundle.runs.size(), 2U);
  EXPECT_EQ(bundle.runs[1].hammer.dof, (Dof{7, 3, -1}));
  EXPECT_EQ(bundle.runs[0].sensors.size(), 2U);
  EXPECT_EQ(bundle.runs[0].sensors[1].dof, (Dof{40, 1, -1}));
  EXPECT_EQ(set.frfs[1].channel, 2U);
  EXPECT_EQ(set.frfs[2].run, 1U);
  EXPECT_EQ(set.frfs[2].channel, 1U);
}

}  // namespace
}  // namespace tapfit::updating
