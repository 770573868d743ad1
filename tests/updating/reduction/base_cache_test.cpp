#include "updating/reduction/base_cache.hpp"

#include "tests/updating/support/deck_support.hpp"
#include "updating/reduction/reduced_base.hpp"
#include "updating/structure/assembly/assemble.hpp"

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>

namespace tapfit::updating {
namespace {

namespace fs = std::filesystem;

class KeptBaseTest : public ::testing::Test {
 protected:
  void SetUp() override {
    const auto* test = ::testing::UnitTest::GetInstance()->current_test_info();
    cache_.folder = fs::path(::testing::TempDir()) /
                    ("tapfit-kept-base-" + std::string(test->name()));
    fs::remove_all(cache_.folder);
    structure::Plate plate;
    plate.a = 0.4;
    plate.b = 0.15;
    plate.thickness = 0.004;
    deck_ = structure::plate_deck(plate, 8, 3);
    for (int j = 1; j <= 4; ++j) deck_.constraints.push_back({j, "123456"});
    options_.high_hz = 300.0;
    options_.points = {6 * 35 + 2, 6 * 12 + 2};
  }
  void TearDown() override { fs::remove_all(cache_.folder); }

  [[nodiscard]] BaseBuilder builder(bool kept) const {
    BaseOptions options = options_;
    if (kept) options.cache = cache_;
    return {deck_, {{"material", 1, "E"}}, options, {}};
  }
  [[nodiscard]] std::size_t files() const {
    if (!fs::exists(cache_.folder)) return 0;
    return static_cast<std::size_t>(
        std::distance(fs::directory_iterator(cache_.folder), {}));
  }

  structure::Deck deck_;
  BaseOptions options_;
  MatrixCache cache_;
};

void expect_same(const ReducedBase& one, const ReducedBase& other) {
  EXPECT_EQ(one.rows.all(), other.rows.all());
  EXPECT_EQ(one.K, other.K);
  EXPECT_EQ(one.part_power, other.part_power);
  EXPECT_EQ(one.K_part, other.K_part);
  EXPECT_EQ(one.M_part, other.M_part);
}

// What is read is what was written, so nothing may differ, not by a bit.
TEST_F(KeptBaseTest, IsTheSameToTheBitWithAndWithoutTheDisk) {
  const BaseBuilder none = builder(false);
  EXPECT_EQ(files(), 0U);
  const BaseBuilder cold = builder(true);
  EXPECT_EQ(files(), 1U);
  const BaseBuilder warm = builder(true);
  const std::vector<int> acted = {6 * 20 + 2};
  for (const BaseBuilder* other : {&cold, &warm}) {
    expect_same(none.build({}, {}), other->build({}, {}));
    expect_same(none.build(acted, {}), other->build(acted, {}));
  }
}

TEST_F(KeptBaseTest, IsSolvedForOnce) {
  const structure::System system = structure::assemble(deck_);
  const std::vector<int> points = {5};
  const auto n = system.dofs();
  int solved = 0;
  const auto solve = [&] {
    ++solved;
    return SolvedBase{Eigen::VectorXd::Random(2),
                      Eigen::MatrixXd::Random(n, 2),
                      Eigen::MatrixXd::Random(n, 3),
                      Eigen::MatrixXd::Random(3, 3),
                      {},
                      {},
                      0.25};
  };
  const auto ask = [&](double high_hz) {
    return kept_or_solved(
        cache_, {system, {}, {}, points, n, high_hz, 4.0}, solve);
  };
  const SolvedBase first = ask(100.0);
  EXPECT_EQ(ask(100.0).V, first.V);
  EXPECT_EQ(ask(100.0).error, 0.25);
  EXPECT_EQ(solved, 1);
  static_cast<void>(ask(101.0));  // another band, another base
  EXPECT_EQ(solved, 2);
}

TEST_F(KeptBaseTest, FollowsTheModelAndSurvivesADamagedFile) {
  static_cast<void>(builder(true));
  deck_.materials.begin()->second.rho *= 1.0 + 1e-12;
  const BaseBuilder changed = builder(true);
  EXPECT_EQ(files(), 2U);
  for (const auto& entry : fs::directory_iterator(cache_.folder)) {
    fs::resize_file(entry, fs::file_size(entry) / 2);
  }
  expect_same(changed.build({}, {}), builder(true).build({}, {}));
}

}  // namespace
}  // namespace tapfit::updating
