// Recordings made elsewhere with a known hidden effect: another plate element,
// a finer mesh and another way of integrating than this project's. Their
// folder lies beside the project and is not part of it.
#include "tests/end_to_end/run_program.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

namespace tapfit::end_to_end {
namespace {

namespace fs = std::filesystem;
using nlohmann::json;

const fs::path cases = TAPFIT_SOURCE_DIR "/../shared/cases";

struct KnownCase {
  std::string folder;
  std::string verdict;
  /// Result parameter, field of truth.json and factor between them, for each
  /// effect of the verdict in truth.json's order; empty: no size.
  struct Size {
    std::string effect;
    std::string parameter;
    std::string truth;
  };
  std::vector<Size> sizes;
};

void PrintTo(const KnownCase& known, std::ostream* out) {
  *out << known.folder;
}

class KnownCases : public testing::TestWithParam<KnownCase> {};

json built_in(const json& truth, const std::string& effect) {
  for (const json& object : truth.at("effects")) {
    if (object.at("effect") == effect) return object;
  }
  return json::object();
}

json sorted(json ids) {
  if (ids.is_array()) std::sort(ids.begin(), ids.end());
  return ids;
}

TEST_P(KnownCases, EffectPlaceAndSizeAreFound) {
  const KnownCase& known = GetParam();
  const fs::path folder = cases / known.folder;
  if (!fs::exists(folder)) GTEST_SKIP() << folder << " is not there";
  const auto result =
      run_tapfit(fmt::format("diagnose '{}' --json", folder.string()));
  ASSERT_EQ(result.exit_status, 0) << result.err;
  const json found = json::parse(result.out);
  const json truth = json::parse(read_file(folder / "truth.json"));
  EXPECT_EQ(found.at("verdict"), known.verdict);
  for (const KnownCase::Size& size : known.sizes) {
    const json hidden = built_in(truth, size.effect);
    bool seen = false;
    for (const json& rung : found.at("ladder")) {
      if (rung.at("added") != size.effect) continue;
      seen = true;
      const double value = rung.at("parameters").at(size.parameter).at("value");
      const double true_value = hidden.at(size.truth);
      // 5 %: what the size of an effect is good for in the lab.
      EXPECT_NEAR(value, true_value, 0.05 * true_value) << size.effect;
      for (const char* place : {"node", "nodes", "elements"}) {
        if (!hidden.contains(place)) continue;
        EXPECT_EQ(sorted(rung.at("where").at(place)), sorted(hidden.at(place)));
      }
    }
    EXPECT_TRUE(seen) << size.effect << " is on no rung";
  }
}

const KnownCase::Size sensor = {"sensor-mass", "mass_kg", "mass_kg"};
const KnownCase::Size clamp = {"soft-support",
                               "rotational_stiffness_nm_per_rad_per_m",
                               "rotational_stiffness_per_m"};

INSTANTIATE_TEST_SUITE_P(
    Shared,
    KnownCases,
    testing::Values(
        KnownCase{"frame-none", "none", {}},
        KnownCase{"frame-sensor-mass", "sensor-mass", {sensor}},
        KnownCase{"frame-soft-support", "soft-support", {clamp}},
        KnownCase{"frame-sensor-mass+soft-support",
                  "sensor-mass+soft-support",
                  {sensor, clamp}},
        KnownCase{"frame-stiffness-loss",
                  "stiffness-loss",
                  {{"stiffness-loss", "factor", "factor"}}},
        KnownCase{"ladder-added-mass",
                  "added-mass",
                  {{"added-mass", "mass_kg", "mass_kg"}}},
        KnownCase{"ladder-dashpot",
                  "dashpot",
                  {{"dashpot", "damping_ns_per_m", "damping_ns_per_m"}}},
        KnownCase{"ladder-joint",
                  "joint",
                  {{"joint",
                    "rotational_stiffness_nm_per_rad_per_m",
                    "rotational_stiffness_per_m"}}},
        KnownCase{"plate-absorber",
                  "absorber",
                  {{"absorber", "mass_kg", "mass_kg"},
                   {"absorber", "frequency_hz", "frequency_hz"}}},
        KnownCase{"plate-channel-gain",
                  "channel-gain",
                  {{"channel-gain", "gain", "gain"}}},
        KnownCase{
            "plate-ground-spring",
            "ground-spring",
            {{"ground-spring", "stiffness_n_per_m", "stiffness_n_per_m"}}},
        KnownCase{"plate-sensor-mass-roving-sensor", "sensor-mass", {sensor}}),
    [](const testing::TestParamInfo<KnownCase>& known) {
      std::string name = known.param.folder;
      for (char& c : name) c = std::isalnum(c) != 0 ? c : '_';
      return name;
    });

}  // namespace
}  // namespace tapfit::end_to_end
