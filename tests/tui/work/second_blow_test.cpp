// A main pulse of 20 N at 1 s and a second one of 3 N, 0.15 s later.
#include "tui/work/second_blow.hpp"

#include "tests/tui/support/fake_results.hpp"

#include <gtest/gtest.h>

namespace tapfit::tui {
namespace {

TEST(SecondBlow, IsTheLargestForceBesideTheMainPulse) {
  acquisition::Recording recording = testing::fake_recordings().front();
  const acquisition::HitSet hits = testing::fake_hits();
  const acquisition::Hit& twice = hits.runs[0][1];
  recording.samples(twice.trigger + 1, 0) = 12.0;  // of the main pulse
  recording.samples(twice.trigger + 38, 0) = -3.0;
  const Trace drawn = trace(recording);
  EXPECT_NEAR(second_blow(drawn, 0, hits, twice),
              static_cast<double>(twice.trigger + 38) / 256.0,
              1e-9);
  // One that is not judged double has none.
  EXPECT_EQ(second_blow(drawn, 0, hits, hits.runs[0][0]),
            hits.runs[0][0].time_s);
}

}  // namespace
}  // namespace tapfit::tui
