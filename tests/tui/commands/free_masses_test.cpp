#include "tui/commands/free_masses.hpp"

#include "acquisition/foundation/input_error.hpp"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

namespace tapfit::tui {
namespace {

acquisition::TestBundle sample_bundle() {
  acquisition::TestBundle bundle;
  bundle.channels.resize(3);
  bundle.channels[0].name = "hammer";
  bundle.channels[0].quantity = acquisition::Quantity::Force;
  bundle.channels[1].name = "acc1";
  bundle.channels[1].mass_kg = 0.02;
  bundle.channels[2].name = "acc2";
  return bundle;
}

/// One FRF of acc1 at its own hit point.
signal::FrfSet sample_frfs() {
  signal::Frf frf;
  frf.response = {.node = 12, .component = 3, .sign = 1};
  frf.reference = frf.response;
  frf.channel = 1;
  frf.H = Eigen::VectorXcd::Constant(2, {10.0, 0.0});
  frf.variance = Eigen::VectorXd::Constant(2, 0.01);
  frf.coherence = Eigen::VectorXd::Ones(2);
  signal::FrfSet set;
  set.s = Eigen::VectorXcd::Constant(2, {0.0, 6.0});
  set.frfs = {frf};
  return set;
}

TEST(FreeMasses, ReadsWords) {
  EXPECT_EQ(parse_free("acc1")->what, "acc1");
  EXPECT_FALSE(parse_free("acc1")->kg.has_value());
  EXPECT_DOUBLE_EQ(*parse_free("acc1=0.02")->kg, 0.02);
  EXPECT_DOUBLE_EQ(parse_free("acc1=0.02,sd=0.001")->sd_kg, 0.001);
  EXPECT_DOUBLE_EQ(parse_free("all,sd=0.001")->sd_kg, 0.001);
  for (const char* wrong : {"",
                            "=0.02",
                            "acc1=",
                            "acc1=x",
                            "acc1=-1",
                            "acc1=0",
                            "acc1,se=1",
                            "acc1=0.02,sd=",
                            "acc1=0.02,sd=-1",
                            "acc1=nan",
                            "acc1=inf"}) {
    EXPECT_FALSE(parse_free(wrong).has_value()) << wrong;
  }
}

TEST(FreeMasses, TakesTheStatedMassWhereNoneIsGiven) {
  for (const char* word : {"acc1", "all"}) {
    const auto loaded = masses_to_free(sample_bundle(), sample_frfs(), {word});
    ASSERT_EQ(loaded.masses.size(), 1U);
    EXPECT_DOUBLE_EQ(loaded.masses[0].kg, 0.02);
    ASSERT_EQ(loaded.loads[0].size(), 1U);
  }
}

TEST(FreeMasses, SaysWhatIsWrongWithAName) {
  const auto free = [](const std::vector<std::string>& words) {
    (void)masses_to_free(sample_bundle(), sample_frfs(), words);
  };
  EXPECT_THROW(free({"acc9"}), InputError);
  EXPECT_THROW(free({"acc2"}), InputError);  // no mass stated
  EXPECT_THROW(free({"hammer=0.1"}), InputError);
  EXPECT_THROW(free({"acc1", "12Z=0.02"}), InputError);
}

TEST(FreeMasses, JsonSaysHowEachWasFreed) {
  const signal::FrfSet set = sample_frfs();
  const auto loaded = masses_to_free(sample_bundle(), set, {"acc1"});
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
  signal::FrfSet set = sample_frfs();
  set.frfs[0].reference.node = 3;
  const auto loaded = masses_to_free(sample_bundle(), set, {"acc1"});
  const std::string text =
      freed_text(set, signal::free_frfs(set, loaded, {}), loaded.masses);
  EXPECT_NE(text.find("12Z+ / 12Z+ was not measured"), std::string::npos)
      << text;
}

}  // namespace
}  // namespace tapfit::tui
