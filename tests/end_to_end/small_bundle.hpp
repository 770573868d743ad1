// A small virtual test that many tests start from, and a cache as users have
// one.
#pragma once

#include <gtest/gtest.h>

#include <filesystem>

namespace tapfit::end_to_end {

/// A ladder with 50 g hidden at grid 200, six runs of three hits: a copy in the
/// running test's own folder, in place of an earlier one. It is simulated once,
/// which takes a second.
[[nodiscard]] std::filesystem::path copy_of_small_bundle();

/// What one run of the program works out is there for the next one of the same
/// test; where tests run else there is no cache.
class WithCache : public testing::Test {
 protected:
  void SetUp() override;
  void TearDown() override;

  /// Where it lies; made when it is first written to.
  [[nodiscard]] const std::filesystem::path& cache() const { return cache_; }

 private:
  std::filesystem::path cache_;
};

}  // namespace tapfit::end_to_end
