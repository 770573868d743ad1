#include "updating/practice/challenge.hpp"

#include "acquisition/foundation/parallel.hpp"
#include "updating/practice/played.hpp"
#include "updating/virtual_test/structure_presets.hpp"
#include "updating/virtual_test/virtual_bundle.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <map>
#include <set>

namespace tapfit::updating {
namespace {

namespace fs = std::filesystem;

TEST(Challenge, SameSeedHidesTheSame) {
  for (const auto level : {ChallengeLevel::Easy, ChallengeLevel::Hard}) {
    const VirtualBundleSpec a = draw_challenge(level, 5, "plate");
    const VirtualBundleSpec b = draw_challenge(level, 5, "plate");
    EXPECT_EQ(a.effects, b.effects);
    EXPECT_EQ(a.noise, b.noise);
    EXPECT_EQ(a.modulus_percent, b.modulus_percent);
    EXPECT_TRUE(a.sealed);
  }
}

TEST(Challenge, EasyHidesOneThingInARightDeck) {
  const std::set<std::string> told_well{"sensor-mass",
                                        "soft-support",
                                        "added-mass",
                                        "ground-spring",
                                        "channel-gain"};
  std::set<std::string> drawn;
  for (std::uint64_t seed = 1; seed <= 12; ++seed) {
    const auto spec = draw_challenge(ChallengeLevel::Easy, seed, "ladder");
    ASSERT_EQ(spec.effects.size(), 1U) << seed;
    EXPECT_TRUE(told_well.contains(spec.effects[0].name));
    drawn.insert(spec.effects[0].name);
    EXPECT_LT(spec.noise, 1.0);
    EXPECT_EQ(spec.modulus_percent, 0.0);
  }
  EXPECT_GE(drawn.size(), 3U);
}

TEST(Challenge, HardHidesNoneOneOrTwo) {
  std::set<std::size_t> counts;
  for (std::uint64_t seed = 1; seed <= 12; ++seed) {
    const auto spec = draw_challenge(ChallengeLevel::Hard, seed, "plate");
    counts.insert(spec.effects.size());
    EXPECT_GT(spec.noise, 1.0);
    EXPECT_GE(std::abs(spec.modulus_percent.value_or(0.0)), 2.0);
    for (const VirtualEffect& effect : spec.effects) {
      EXPECT_NE(effect.name, "soft-support") << "the plate hangs free";
      EXPECT_EQ(parse_virtual_effect(virtual_effect_text(effect)), effect);
    }
  }
  EXPECT_EQ(counts, (std::set<std::size_t>{0, 1, 2}));
}

// Each by the definition of its size.
TEST(Challenge, AnEffectIsResizedByWhatItDoes) {
  const auto values = [](const char* text, double share) {
    return resized(parse_virtual_effect(text), share).values;
  };
  using Values = std::vector<double>;
  EXPECT_EQ(values("added-mass@7=0.5", 0.5), Values{0.25});
  EXPECT_EQ(values("sensor-mass=0.5,0.25", 2.0), (Values{1.0, 0.5}));
  EXPECT_EQ(values("soft-support@both=3,8", 0.5), (Values{6.0, 16.0}));
  EXPECT_EQ(values("stiffness-loss@1:2=0.5", 0.5), Values{0.75});
  EXPECT_EQ(values("channel-gain@acc1=0.5", 0.5), Values{0.75});
  EXPECT_EQ(values("absorber@7=0.5,30,0.01", 0.5), (Values{0.25, 30.0, 0.01}));
  EXPECT_TRUE(values("channel-polarity@acc1", 0.5).empty());
}

std::map<std::string, std::string> bytes_in(const fs::path& folder) {
  std::map<std::string, std::string> bytes;
  for (const fs::directory_entry& entry : fs::directory_iterator(folder)) {
    std::ifstream in(entry.path(), std::ios::binary);
    bytes[entry.path().filename().string()] = {
        std::istreambuf_iterator<char>(in), {}};
  }
  return bytes;
}

TEST(Challenge, SameSeedSameBytesOnHoweverManyThreads) {
  const fs::path root = fs::path(testing::TempDir()) / "tapfit-challenge-bytes";
  fs::remove_all(root);
  VirtualBundleSpec spec = draw_challenge(ChallengeLevel::Hard, 3, "portal");
  spec.points = 3;
  spec.hits = 1;
  make_virtual_bundle(spec, root / "many");
  // Each piece of parallel work has one thread to itself.
  for_each_parallel(2, [&](std::size_t k) {
    make_virtual_bundle(spec, root / std::to_string(k));
  });
  const auto many = bytes_in(root / "many");
  EXPECT_EQ(many, bytes_in(root / "0"));
  EXPECT_EQ(many, bytes_in(root / "1"));
  EXPECT_TRUE(many.contains("sealed.json"));
  EXPECT_FALSE(many.contains("truth.json"));
}

TEST(Played, EffectsAddedByHandAreAVerdict) {
  Rung base;
  base.added = base_rung;
  base.error = 0.5;
  Rung properties = base;
  properties.added = uncertain_rung;
  properties.error = 0.4;
  EXPECT_EQ(as_diagnosis({base, properties}, 0.01).verdict, "none");
  Rung mass = base;
  mass.added = "added-mass";
  mass.error = 0.1;
  Rung spring = base;
  spring.added = "ground-spring";
  spring.error = 0.02;
  const Diagnosis found = as_diagnosis({base, properties, mass, spring}, 0.01);
  EXPECT_EQ(found.verdict, "added-mass+ground-spring");
  EXPECT_EQ(found.ladder.size(), 2U);
  EXPECT_EQ(found.error_base, 0.5);
  EXPECT_EQ(found.error_best, 0.02);
  EXPECT_EQ(found.floor, 0.01);
}

}  // namespace
}  // namespace tapfit::updating
