#include "tui/workbench/worker.hpp"

#include "tests/tui/support/fake_workbench.hpp"

#include <gtest/gtest.h>

#include <chrono>
#include <thread>
#include <utility>
#include <vector>

namespace tapfit::tui {
namespace {

using std::chrono::milliseconds;

/// Waits for a job's end; fails after five seconds, far beyond any need.
std::optional<Finished> wait_for(Worker& worker) {
  for (int i = 0; i < 5000; ++i) {
    if (std::optional<Finished> end = worker.take_finished()) return end;
    std::this_thread::sleep_for(milliseconds(1));
  }
  return std::nullopt;
}

TEST(Worker, HandsOverTheBundleAtOnce) {
  Worker worker(testing::fake_workbench());
  const std::optional<Finished> end = worker.take_finished();
  ASSERT_TRUE(end.has_value());
  EXPECT_EQ(end->snapshot.bundle->title, "Made-up strip");
  EXPECT_TRUE(end->snapshot.has_model);
}

// From 10 to 40 % in six seconds: the other 60 % take twelve.
TEST(Worker, TellsHowLongAStageWillTake) {
  using std::chrono::seconds;
  WorkerStatus status;
  status.part_since = std::chrono::steady_clock::now();
  status.part_from = 0.1;
  status.fraction = 0.4;
  const auto left = part_left_s(status, status.part_since + seconds(6));
  ASSERT_TRUE(left.has_value());
  EXPECT_NEAR(*left, 12.0, 1e-9);
  EXPECT_FALSE(part_left_s(status, status.part_since + seconds(1)));
  status.fraction = 0.12;
  EXPECT_FALSE(part_left_s(status, status.part_since + seconds(6)));
}

// A stage that goes on from the share before is of the same work.
TEST(Worker, KnowsWhatItsShareIsOf) {
  Worker worker(testing::fake_workbench());
  (void)worker.take_finished();
  std::vector<WorkerStatus> seen;
  Job job;
  job.run = [&](Workbench&, Snapshot&, const Progress& progress) {
    for (const auto& [stage, far] : std::vector<std::pair<const char*, double>>{
             {"screening", 0.1}, {"fitting", 0.4}, {"ladder", 0.0}}) {
      progress(stage, far);
      seen.push_back(worker.status());
    }
    return std::string();
  };
  worker.start(std::move(job));
  ASSERT_TRUE(wait_for(worker).has_value());
  ASSERT_EQ(seen.size(), 3U);
  EXPECT_EQ(seen[1].part_from, 0.1);
  EXPECT_EQ(seen[1].part_since, seen[0].part_since);
  EXPECT_FALSE(seen[1].in_parts);
  EXPECT_EQ(seen[2].part_from, 0.0);
  EXPECT_TRUE(seen[2].in_parts);
}

TEST(Worker, MakesAResult) {
  Worker worker(testing::fake_workbench());
  (void)worker.take_finished();
  worker.start(make({Stage::Modes}));
  const std::optional<Finished> end = wait_for(worker);
  ASSERT_TRUE(end.has_value());
  EXPECT_EQ(end->how, Finished::How::Done);
  ASSERT_TRUE(end->snapshot.has({Stage::Modes}));
  EXPECT_EQ(end->snapshot.modes->modes.size(), 3U);
  EXPECT_FALSE(worker.status().busy);
}

TEST(Worker, TellsWhatWasThrown) {
  testing::FakeOptions options;
  options.hits_fail = true;
  Worker worker(testing::fake_workbench(options));
  (void)worker.take_finished();
  worker.start(make({Stage::Hits}));
  const std::optional<Finished> end = wait_for(worker);
  ASSERT_TRUE(end.has_value());
  EXPECT_EQ(end->how, Finished::How::Failed);
  EXPECT_NE(end->message.find("no hit was found"), std::string::npos);
}

TEST(Worker, StopsEndlessWorkAndGoesOn) {
  testing::FakeOptions options;
  options.endless_modes = true;
  Worker worker(testing::fake_workbench(options));
  (void)worker.take_finished();
  worker.start(make({Stage::Modes}));
  while (worker.status().stage != "fitting") {
    std::this_thread::sleep_for(milliseconds(1));
  }
  EXPECT_DOUBLE_EQ(worker.status().fraction, 0.43);
  worker.stop();
  std::optional<Finished> end = wait_for(worker);
  ASSERT_TRUE(end.has_value());
  EXPECT_EQ(end->how, Finished::How::Stopped);
  worker.start(make({Stage::Frfs}));
  end = wait_for(worker);
  ASSERT_TRUE(end.has_value());
  EXPECT_EQ(end->how, Finished::How::Done);
}

TEST(Worker, EndsWhileItWorks) {
  testing::FakeOptions options;
  options.endless_modes = true;
  const auto begin = std::chrono::steady_clock::now();
  {
    Worker worker(testing::fake_workbench(options));
    (void)worker.take_finished();
    worker.start(make({Stage::Modes}));
  }
  EXPECT_LT(std::chrono::steady_clock::now() - begin, milliseconds(3000));
}

}  // namespace
}  // namespace tapfit::tui
