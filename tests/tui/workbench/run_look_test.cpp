// A run looked at closely, against the stages that it stands for.
#include "tui/workbench/run_look.hpp"

#include "signal/estimate/estimate_frfs.hpp"
#include "tests/tui/support/fake_workbench.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace tapfit::tui {
namespace {

struct MadeUp {
  acquisition::TestBundle bundle = testing::fake_bundle();
  std::vector<acquisition::Recording> recordings = testing::fake_recordings();
  acquisition::HitSet hits = testing::fake_hits();
};

TEST(RunLook, AverageOfAllHitsIsTheFrf) {
  const MadeUp t;
  const RunLook look = look_at_run(t.bundle, t.recordings, t.hits, 0);
  const signal::FrfSet set =
      signal::estimate_frfs(t.bundle, t.recordings, t.hits, {});
  ASSERT_EQ(look.averages.size(), 2U);  // the second of three is rejected
  ASSERT_EQ(look.averages.back().size(), 2U);
  for (std::size_t sensor = 0; sensor < 2; ++sensor) {
    const signal::Frf& found = look.averages.back()[sensor];
    const signal::Frf& wanted = set.frfs[sensor];
    EXPECT_EQ(found.hits, 2);
    // The same sums in the same order.
    EXPECT_LT((found.H - wanted.H).norm(), 1e-12 * wanted.H.norm());
  }
  EXPECT_EQ(look.averages.front()[0].hits, 1);
}

TEST(RunLook, WindowsLieWhereTheHitsDo) {
  const MadeUp t;
  const RunLook look = look_at_run(t.bundle, t.recordings, t.hits, 0);
  ASSERT_EQ(look.windows.size(), 3U);
  const double dt = 1.0 / t.hits.sample_rate_hz;
  for (std::size_t k = 0; k < 3; ++k) {
    ASSERT_TRUE(look.windows[k]);
    const HitWindow& window = *look.windows[k];
    const auto trigger = static_cast<double>(t.hits.runs[0][k].trigger) * dt;
    EXPECT_NEAR(window.trigger_s, trigger, 1e-12);
    EXPECT_NEAR(window.begin_s, trigger - 10.0 * dt, 1e-12);
    EXPECT_NEAR(window.end_s - window.begin_s, 700.0 * dt, 1e-12);
    // Open over the pulse, at most a tenth of the block behind it.
    EXPECT_NEAR(window.pulse.maxCoeff(), 1.0, 1e-12);
    EXPECT_LE(window.pulse_s, trigger);
    EXPECT_LT(window.pulse_s + static_cast<double>(window.pulse.size()) * dt,
              trigger + 70 * dt);
    // 1 at the trigger, one per cent at the block's end.
    EXPECT_NEAR(window.exponential(trigger), 1.0, 1e-12);
    EXPECT_NEAR(window.exponential(window.end_s), 0.01, 1e-9);
    EXPECT_EQ(window.exponential(window.end_s + 1.0), 0.0);
  }
}

TEST(RunLook, HitsThatAgreeAreCoherent) {
  const MadeUp t;
  const RunLook look = look_at_run(t.bundle, t.recordings, t.hits, 0);
  ASSERT_EQ(look.coherence.with_others.rows(), 2);
  ASSERT_EQ(look.coherence.with_others.cols(), 2);
  // The fake recording repeats the same blow without noise.
  EXPECT_GT(look.coherence.with_others.minCoeff(), 0.999);
}

// Another file of the same point: its hits go on where the first's ended.
TEST(RunLook, GoesOnFromEarlierRunsAtTheSamePoints) {
  MadeUp t;
  t.bundle.runs.resize(1);
  t.recordings.resize(1);
  t.hits.runs.resize(1);
  t.bundle.runs.push_back(t.bundle.runs[0]);
  std::swap(t.bundle.runs[1].sensors[0], t.bundle.runs[1].sensors[1]);
  t.recordings.push_back(t.recordings[0]);
  t.hits.runs.push_back(t.hits.runs[0]);
  const RunLook first = look_at_run(t.bundle, t.recordings, t.hits, 0);
  const RunLook look = look_at_run(t.bundle, t.recordings, t.hits, 1);
  ASSERT_EQ(look.averages.size(), 2U);
  EXPECT_EQ(look.averages[0][0].hits, 3);
  EXPECT_EQ(look.averages[1][0].hits, 4);
  EXPECT_EQ(look.averages[1][0].channel, t.bundle.runs[1].sensors[0].channel);
  const signal::FrfSet set =
      signal::estimate_frfs(t.bundle, t.recordings, t.hits, {});
  ASSERT_EQ(set.frfs.size(), 2U);
  EXPECT_LT((look.averages.back()[0].H - set.frfs[1].H).norm(),
            1e-12 * set.frfs[1].H.norm());
  EXPECT_EQ(look.coherence.hits, first.coherence.hits);
  EXPECT_EQ(look.coherence.with_others.cols(), 2);
}

}  // namespace
}  // namespace tapfit::tui
