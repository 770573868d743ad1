// Elastic moduli of a free plate from a hammer test of one point: hit at one
// corner, felt at another.
#include "tests/acquisition/temporary_folder.hpp"
#include "updating/effect_place.hpp"
#include "updating/session.hpp"
#include "updating/virtual_bundle.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <cmath>
#include <fstream>
#include <map>

namespace tapfit::updating {
namespace {

using nlohmann::json;

// 0.58 m x 0.22 m x 4.7 mm, 0.25 kg: a guitar's top before it is carved.
std::string plate(const std::string& material) {
  constexpr int nx = 16;
  constexpr int ny = 8;
  std::string deck =
      "PARAM,COUPMASS,1\n" + material + "PSHELL,1,1,0.0047,1,,1\n";
  const auto id = [](int i, int j) { return 1 + i * (ny + 1) + j; };
  for (int i = 0; i <= nx; ++i) {
    for (int j = 0; j <= ny; ++j) {
      deck += fmt::format("GRID,{},,{:.6f},{:.6f},0.\n",
                          id(i, j),
                          0.58 * i / nx,
                          0.22 * j / ny);
    }
  }
  int element = 0;
  for (int i = 0; i < nx; ++i) {
    for (int j = 0; j < ny; ++j) {
      deck += fmt::format("CQUAD4,{},1,{},{},{},{}\n",
                          ++element,
                          id(i, j),
                          id(i + 1, j),
                          id(i + 1, j + 1),
                          id(i, j + 1));
    }
  }
  return deck + "ENDDATA\n";
}

std::map<std::string, Estimate> by_name(const std::vector<Estimate>& list) {
  std::map<std::string, Estimate> result;
  for (const Estimate& e : list) result.emplace(e.name, e);
  return result;
}

// Records a plate of the true material and identifies that of the engineer's
// deck, from the runs whose hammer and sensor are on different corners; where
// the sensors weigh something, both are used and their mass is identified too.
std::map<std::string, Estimate> identified(
    const std::string& truth,
    const std::string& deck,
    const std::vector<std::string>& properties,
    std::uint64_t seed,
    double sensor_kg = 0.0) {
  const tapfit::testing::TemporaryFolder folder;
  folder.write("truth.bdf", plate(truth));
  VirtualBundleSpec spec;
  spec.structure = (folder.path() / "truth.bdf").string();
  spec.seed = seed;
  spec.points = 2;
  spec.hits = 4;
  spec.band_hz = {50.0, 600.0};
  spec.modulus_percent = 0.0;
  spec.damping_mean = 0.008;
  if (sensor_kg > 0.0) {
    spec.effects = {
        parse_virtual_effect(fmt::format("sensor-mass={}", sensor_kg))};
  }
  make_virtual_bundle(spec, folder.path() / "test");
  folder.write("test/model.bdf", plate(deck));
  std::ifstream in(folder.path() / "test" / "test.json");
  json test = json::parse(in);
  const json sensors = test["runs"][0]["sensors"];
  const int hit = test["runs"][0]["hammer"]["node"];
  test["runs"] = json::array({test["runs"][0]});
  for (const json& sensor : sensors) {
    if (sensor_kg == 0.0 && sensor["node"] != hit) {
      test["runs"][0]["sensors"] = {sensor};
    }
  }
  test["uncertain"] = json::array();
  for (const std::string& property : properties) {
    test["uncertain"].push_back(
        {{"material", 1}, {"property", property}, {"sd_percent", 15.0}});
  }
  folder.write("test/test.json", test.dump());
  Session session(folder.path() / "test");
  session.fit_uncertain();
  if (sensor_kg > 0.0) session.add(parse_effect("sensor-mass"));
  return by_name(session.model_parameters());
}

TEST(PlateStiffness, ModulusOfAnIsotropicPlateIsWithinOnePercent) {
  for (const std::uint64_t seed : {1U, 2U}) {
    const auto found = identified("MAT1,1,6.9+10,,.33,2700.\n",
                                  "MAT1,1,7.6+10,,.33,2700.\n",
                                  {"E"},
                                  seed);
    EXPECT_NEAR(found.at("E:1").value, 6.9e10, 0.01 * 6.9e10) << seed;
  }
}

TEST(PlateStiffness, ModuliOfASprucePlateAreWithinTwoPercent) {
  for (const std::uint64_t seed : {1U, 2U}) {
    const auto found =
        identified("MAT8,1,1.2+10,.8+9,.4,.75+9,.75+9,.1+9,417.\n",
                   "MAT8,1,1.1+10,.9+9,.4,.7+9,.75+9,.1+9,417.\n",
                   {"E1", "E2", "G12"},
                   seed);
    for (const auto& [name, truth] : {std::pair{"E1:1", 1.2e10},
                                      std::pair{"E2:1", 0.8e9},
                                      std::pair{"G12:1", 0.75e9}}) {
      const Estimate& e = found.at(name);
      EXPECT_NEAR(e.value, truth, 0.02 * truth) << name << ", seed " << seed;
      // Standard errors that are no ornament: neither beyond four of them, nor
      // so wide that they say nothing.
      EXPECT_LT(std::abs(e.value - truth), 4.0 * e.sd) << name;
      EXPECT_LT(e.sd, 0.02 * truth) << name;
    }
  }
}

// Frequencies tell the moduli over the mass; the scale of the FRFs alone tells
// the mass.
TEST(PlateStiffness, ModuliComeOutWithTheMassUnknownToo) {
  for (const double sensor_kg : {0.0, 0.004}) {
    const auto found =
        identified("MAT8,1,1.2+10,.8+9,.4,.75+9,.75+9,.1+9,417.\n",
                   "MAT8,1,1.1+10,.9+9,.4,.7+9,.75+9,.1+9,400.\n",
                   {"E1", "E2", "G12", "rho"},
                   3,
                   sensor_kg);
    for (const auto& [name, truth] : {std::pair{"E1:1", 1.2e10},
                                      std::pair{"E2:1", 0.8e9},
                                      std::pair{"G12:1", 0.75e9},
                                      std::pair{"rho:1", 417.0}}) {
      const Estimate& e = found.at(name);
      EXPECT_NEAR(e.value, truth, 0.02 * truth) << name << ' ' << sensor_kg;
      // Eight values are looked at: one in forty tests would go beyond three.
      EXPECT_LT(std::abs(e.value - truth), 3.0 * e.sd) << name << sensor_kg;
    }
    if (sensor_kg == 0.0) continue;
    const Estimate& mass = found.at("sensor-mass mass_kg");
    EXPECT_NEAR(mass.value, sensor_kg, 0.05 * sensor_kg);
  }
}

}  // namespace
}  // namespace tapfit::updating
