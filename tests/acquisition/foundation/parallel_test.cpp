#include "acquisition/foundation/parallel.hpp"

#include <gtest/gtest.h>

#include <atomic>
#include <stdexcept>
#include <string>
#include <thread>
#include <vector>

namespace tapfit {
namespace {

TEST(Parallel, DoesEachPieceOnce) {
  std::vector<std::atomic<int>> count(1000);
  for_each_parallel(count.size(), [&](std::size_t k) { ++count[k]; });
  for (const auto& times : count) EXPECT_EQ(times, 1);
  for_each_parallel(0, [](std::size_t) { FAIL(); });
}

TEST(Parallel, ThrowsOnWhatFailedFirstInOrder) {
  for (int round = 0; round < 20; ++round) {
    try {
      for_each_parallel(100, [](std::size_t k) {
        if (k >= 7) throw std::runtime_error(std::to_string(k));
        std::this_thread::yield();
      });
      FAIL();
    } catch (const std::runtime_error& error) {
      EXPECT_STREQ(error.what(), "7");
    }
  }
}

TEST(Parallel, TakesNoFurtherThreadsWithinAPiece) {
  std::atomic<int> elsewhere = 0;
  for_each_parallel(4, [&](std::size_t) {
    const auto here = std::this_thread::get_id();
    for_each_parallel(4, [&](std::size_t) {
      elsewhere += std::this_thread::get_id() != here;
    });
  });
  EXPECT_EQ(elsewhere, 0);
}

}  // namespace
}  // namespace tapfit
