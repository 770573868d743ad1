#include "tui/commands/free_masses.hpp"

#include "signal/mass_removal/named_masses.hpp"
#include "tests/signal/support/known_masses.hpp"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

namespace tapfit::tui {
namespace {

TEST(FreeMasses, JsonSaysHowEachWasFreed) {
  const signal::FrfSet set = signal::frfs_with_masses();
  const auto loaded =
      signal::masses_to_free(signal::bundle_with_masses(), set, {"acc1"});
  const signal::FreedFrfs freed = signal::free_frfs(set, loaded, {});
  const auto json = freed_json(set, freed, loaded.masses);
  const auto& frf = json.at("frfs").at(0);
  EXPECT_EQ(frf.at("freed"), "measurement");
  // sd 0.1 of 10; A / (1 - m A) = 12.5 with sd 0.1 / 0.8^2.
  EXPECT_NEAR(frf.at("measured_sd_percent").get<double>(), 1.0, 1e-12);
  EXPECT_NEAR(frf.at("median_sd_percent").get<double>(), 1.25, 1e-12);
  EXPECT_EQ(json.at("masses").dump(),
            R"([{"of":"acc1","mass_kg":0.02,"sd_kg":0.0}])");
}

TEST(FreeMasses, TextNamesReasons) {
  signal::FrfSet set = signal::frfs_with_masses();
  set.frfs[0].reference.node = 3;
  const auto loaded =
      signal::masses_to_free(signal::bundle_with_masses(), set, {"acc1"});
  const std::string text =
      freed_text(set, signal::free_frfs(set, loaded, {}), loaded.masses);
  EXPECT_NE(text.find("12Z+ / 12Z+ was not measured"), std::string::npos)
      << text;
}

}  // namespace
}  // namespace tapfit::tui
