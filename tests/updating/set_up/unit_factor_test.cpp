#include "tests/updating/support/sample_plate.hpp"
#include "updating/set_up/mistakes.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <set>

namespace tapfit::effects {
namespace {

Location reading(const std::string& slip) {
  return {.channels = {"acc1"}, .variant = slip};
}

std::complex<double> read_by(const std::string& slip,
                             bool hammer,
                             std::complex<double> s) {
  const Effect& effect = unit_factor();
  return effect.law(s, {}, effect.passed_as(reading(slip), hammer));
}

TEST(UnitFactor, MultipliesASensorsFrfsAndDividesAHammers) {
  const std::complex<double> s(1.0, 300.0);
  EXPECT_NEAR(std::abs(read_by("9.807", false, s) - 9.80665), 0.0, 1e-12);
  EXPECT_NEAR(std::abs(read_by("9.807", true, s) - 1.0 / 9.80665), 0.0, 1e-12);
  EXPECT_NEAR(std::abs(read_by("1/1000", false, s) - 1e-3), 0.0, 1e-15);
}

TEST(UnitFactor, IntegratesOverS) {
  const std::complex<double> s(1.0, 300.0);
  EXPECT_NEAR(std::abs(read_by("integrated", false, s) * s - 1.0), 0.0, 1e-12);
  EXPECT_NEAR(
      std::abs(read_by("integrated-twice", false, s) * s * s - 1.0), 0.0, 1e-9);
}

TEST(UnitFactor, HasEachFactorOnce) {
  const Effect& effect = unit_factor();
  std::set<std::string> names;
  std::vector<double> logs;
  for (const std::string& slip : effect.variants()) {
    EXPECT_TRUE(names.insert(slip).second) << slip;
    for (const Effect::Fixed& fixed : effect.fixed(reading(slip))) {
      EXPECT_EQ(fixed.name, "factor");
      logs.push_back(std::log(fixed.value));
    }
  }
  std::ranges::sort(logs);
  for (std::size_t k = 1; k < logs.size(); ++k) {
    EXPECT_GT(logs[k] - logs[k - 1], 1e-4) << std::exp(logs[k]);
  }
  EXPECT_TRUE(names.contains("2.205")) << "kgf for lbf";
  EXPECT_TRUE(names.contains("39.37")) << "inches for metres";
}

TEST(UnitFactor, IsSoughtInAllRunsAndInEach) {
  const structure::Deck deck = support::plate_deck(true);
  const acquisition::TestBundle bundle = support::plate_bundle();
  const std::vector<Location> places =
      unit_factor().places(support::plate_context(bundle, deck));
  Location single = reading("10");
  EXPECT_EQ(std::ranges::count(places, single), 1);
  single.runs = {6};
  EXPECT_EQ(std::ranges::count(places, single), 1);
  // An accelerometer is no displacement sensor from one run to the next, and no
  // sensor of what no one measures.
  Location integrated = reading("integrated");
  EXPECT_EQ(std::ranges::count(places, integrated), 1);
  integrated.runs = {6};
  EXPECT_EQ(std::ranges::count(places, integrated), 0);
  EXPECT_EQ(std::ranges::count(places, reading("differentiated")), 0);
}

// Runs of one placement are averaged: a range of one of them is that of all.
TEST(UnitFactor, IsSoughtInTheRunsOfEachAverage) {
  const structure::Deck deck = support::plate_deck(true);
  acquisition::TestBundle bundle = support::plate_bundle();
  bundle.runs[5].hammer.dof = bundle.runs[1].hammer.dof;
  const auto places = [&] {
    return unit_factor().places(support::plate_context(bundle, deck));
  };
  Location single = reading("10");
  single.runs = {2, 6};
  EXPECT_EQ(std::ranges::count(places(), single), 1);
  for (const int run : {2, 6}) {
    single.runs = {run};
    EXPECT_EQ(std::ranges::count(places(), single), 0) << run;
  }
  for (acquisition::Run& run : bundle.runs) run = bundle.runs.front();
  EXPECT_TRUE(std::ranges::all_of(places(), [](const Location& where) {
    return where.runs.empty();
  })) << "one average is all there is";
}

}  // namespace
}  // namespace tapfit::effects
