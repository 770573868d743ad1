#include "tui/options/progress_line.hpp"

#include <gtest/gtest.h>

#include <chrono>
#include <csignal>
#include <thread>

namespace tapfit::tui {
namespace {

// Work that is long at one thing reports nothing.
TEST(ProgressLine, AsksWorkToStopThatDoesNotReport) {
  ProgressLine line(false);
  const Progress progress = line.progress();
  EXPECT_FALSE(progress.stop.stop_requested());
  ASSERT_EQ(std::raise(SIGTERM), 0);
  const auto until = std::chrono::steady_clock::now() + std::chrono::seconds(5);
  while (!progress.stop.stop_requested() &&
         std::chrono::steady_clock::now() < until) {
    std::this_thread::sleep_for(std::chrono::milliseconds(1));
  }
  EXPECT_TRUE(progress.stop.stop_requested());
}

TEST(ProgressLine, EndsWithoutASignalToo) {
  std::stop_token stop;
  {
    ProgressLine line(false);
    stop = line.progress().stop;
  }
  EXPECT_FALSE(stop.stop_requested());
}

}  // namespace
}  // namespace tapfit::tui
