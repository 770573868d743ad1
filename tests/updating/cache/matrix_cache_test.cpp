#include "updating/cache/matrix_cache.hpp"

#include <gtest/gtest.h>

#include <chrono>
#include <cmath>
#include <cstdlib>
#include <fstream>
#include <limits>

namespace tapfit::updating {
namespace {

namespace fs = std::filesystem;

using Eigen::MatrixXd;

class MatrixCacheTest : public ::testing::Test {
 protected:
  void SetUp() override {
    const auto* test = testing::UnitTest::GetInstance()->current_test_info();
    cache_.folder = fs::path(testing::TempDir()) /
                    ("tapfit-matrix-cache-" + std::string(test->name()));
    fs::remove_all(cache_.folder);
  }
  void TearDown() override { fs::remove_all(cache_.folder); }

  [[nodiscard]] fs::path file() const {
    return fs::directory_iterator(cache_.folder)->path();
  }
  [[nodiscard]] std::size_t files() const {
    return static_cast<std::size_t>(
        std::distance(fs::directory_iterator(cache_.folder), {}));
  }
  void overwrite(std::streamoff at, char byte) const {
    std::fstream stream(file(),
                        std::ios::binary | std::ios::in | std::ios::out);
    stream.seekp(at);
    stream.put(byte);
  }

  MatrixCache cache_;
  const Digest key_ = {1, 2};
  const std::vector<MatrixXd> matrices_ = {
      MatrixXd::Random(7, 3), MatrixXd(0, 4), MatrixXd::Constant(1, 1, -0.0)};
};

TEST_F(MatrixCacheTest, GivesBackWhatItWasGiven) {
  EXPECT_FALSE(cache_.load(key_));
  ASSERT_TRUE(cache_.store(key_, matrices_));
  const auto back = cache_.load(key_);
  ASSERT_TRUE(back);
  ASSERT_EQ(back->size(), matrices_.size());
  for (std::size_t k = 0; k < back->size(); ++k)
    EXPECT_EQ((*back)[k], matrices_[k]);
  EXPECT_TRUE(std::signbit((*back)[2](0, 0)));  // to the bit
  EXPECT_EQ(files(), 1U);                       // nothing unfinished is left
  EXPECT_FALSE(cache_.load({1, 3}));
}

TEST_F(MatrixCacheTest, IgnoresADamagedNumberSizeOrHead) {
  ASSERT_TRUE(cache_.store(key_, matrices_));
  const auto length = static_cast<std::streamoff>(fs::file_size(file()));
  // In turn: the magic, version, key, digest, sizes, a number in the middle,
  // the last byte. 0x5a is at none of these places by itself.
  for (const std::streamoff at : {std::streamoff{0},
                                  std::streamoff{8},
                                  std::streamoff{16},
                                  std::streamoff{32},
                                  std::streamoff{56},
                                  length / 2,
                                  length - 1}) {
    ASSERT_TRUE(cache_.store(key_, matrices_));
    ASSERT_TRUE(cache_.load(key_));
    overwrite(at, 0x5a);
    EXPECT_FALSE(cache_.load(key_)) << "byte " << at;
  }
}

TEST_F(MatrixCacheTest, IgnoresAFileOfTheWrongLengthOrKey) {
  ASSERT_TRUE(cache_.store(key_, matrices_));
  const fs::path whole = file();
  fs::copy(whole, cache_.folder / "copy");
  for (const std::uintmax_t length : {std::uintmax_t{0},
                                      std::uintmax_t{20},
                                      fs::file_size(whole) - 1,
                                      fs::file_size(whole) + 1}) {
    fs::copy(
        cache_.folder / "copy", whole, fs::copy_options::overwrite_existing);
    ASSERT_TRUE(cache_.load(key_));
    fs::resize_file(whole, length);
    EXPECT_FALSE(cache_.load(key_)) << length;
  }
  fs::copy(cache_.folder / "copy", whole, fs::copy_options::overwrite_existing);
  const Digest other = {3, 4};
  fs::copy(whole, cache_.folder / (hexadecimal(other) + ".matrices"));
  EXPECT_FALSE(cache_.load(other));
}

TEST_F(MatrixCacheTest, IgnoresSizesThatNoMemoryHolds) {
  ASSERT_TRUE(cache_.store(key_, matrices_));
  // Rows of the first matrix become some 2^62.
  overwrite(56 + 7, 0x40);
  EXPECT_FALSE(cache_.load(key_));
}

TEST_F(MatrixCacheTest, DropsWhatWasUsedLongestAgo) {
  const std::vector<MatrixXd> large = {MatrixXd::Zero(100, 100)};  // 80 kB
  cache_.limit = 200000;
  ASSERT_TRUE(cache_.store({1, 0}, large));
  ASSERT_TRUE(cache_.store({2, 0}, large));
  for (const auto& entry : fs::directory_iterator(cache_.folder)) {
    fs::last_write_time(
        entry, fs::file_time_type::clock::now() - std::chrono::hours(1));
  }
  ASSERT_TRUE(cache_.load({1, 0}));  // used now
  ASSERT_TRUE(cache_.store({3, 0}, large));
  EXPECT_TRUE(cache_.load({1, 0}));
  EXPECT_FALSE(cache_.load({2, 0}));
  EXPECT_TRUE(cache_.load({3, 0}));
  EXPECT_FALSE(cache_.store({4, 0}, {MatrixXd::Zero(200, 200)}));
  EXPECT_EQ(files(), 2U);  // what does not fit at all drops nothing
}

TEST_F(MatrixCacheTest, IsSilentWhereNothingCanBeWritten) {
  std::ofstream(cache_.folder) << "a file";  // where the folder should be
  EXPECT_FALSE(cache_.store(key_, matrices_));
  EXPECT_FALSE(cache_.load(key_));
  // No file can be made here, not even by root.
  const MatrixCache nowhere{"/proc/tapfit"};
  EXPECT_FALSE(nowhere.store(key_, matrices_));
}

TEST_F(MatrixCacheTest, LiesWhereTheEnvironmentSays) {
  ::setenv("XDG_CACHE_HOME", "/tmp/somewhere", 1);
  ::unsetenv("TAPFIT_NO_CACHE");
  ASSERT_TRUE(user_cache());
  EXPECT_EQ(user_cache()->folder, "/tmp/somewhere/tapfit");
  ::setenv("TAPFIT_NO_CACHE", "1", 1);
  EXPECT_FALSE(user_cache());
  ::setenv("TAPFIT_NO_CACHE", "0", 1);
  EXPECT_TRUE(user_cache());
  ::unsetenv("XDG_CACHE_HOME");
  ::setenv("HOME", "/home/somebody", 1);
  EXPECT_EQ(user_cache()->folder, "/home/somebody/.cache/tapfit");
  ::setenv("TAPFIT_NO_CACHE", "1", 1);
}

}  // namespace
}  // namespace tapfit::updating
