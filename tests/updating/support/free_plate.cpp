#include "tests/updating/support/free_plate.hpp"

#include "tests/acquisition/support/temporary_folder.hpp"
#include "updating/catalogue/effect_place.hpp"
#include "updating/session/session.hpp"
#include "updating/virtual_test/virtual_bundle.hpp"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <fstream>

namespace tapfit::support {

using nlohmann::json;

std::string free_plate_deck(const std::string& material, int along) {
  const int nx = along;
  const int ny = along / 2;
  std::string deck =
      "PARAM,COUPMASS,1\n" + material + "PSHELL,1,1,0.0047,1,,1\n";
  const auto id = [ny](int i, int j) { return 1 + i * (ny + 1) + j; };
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

namespace {

// test.json with the one run, and in it what is uncertain.
json one_run_of(json test, const PlateTest& plate) {
  const json sensors = test["runs"][0]["sensors"];
  const int hit = test["runs"][0]["hammer"]["node"];
  test["runs"] = json::array({test["runs"][0]});
  for (const json& sensor : sensors) {
    if (plate.sensor_kg == 0.0 && sensor["node"] != hit) {
      test["runs"][0]["sensors"] = {sensor};
    }
  }
  test["uncertain"] = json::array();
  for (const std::string& property : plate.properties) {
    test["uncertain"].push_back(
        {{"material", 1}, {"property", property}, {"sd_percent", 15.0}});
  }
  return test;
}

}  // namespace

std::map<std::string, updating::Estimate> identify_plate(
    const PlateTest& plate) {
  const tapfit::testing::TemporaryFolder folder;
  folder.write("truth.bdf", free_plate_deck(plate.truth, plate.shells_along));
  updating::VirtualBundleSpec spec;
  spec.structure = (folder.path() / "truth.bdf").string();
  spec.seed = plate.seed;
  spec.points = 2;
  spec.hits = 4;
  spec.band_hz = plate.band_hz;
  spec.modulus_percent = 0.0;
  spec.damping_mean = 0.008;
  if (plate.sensor_kg > 0.0) {
    spec.effects = {updating::parse_virtual_effect(
        fmt::format("sensor-mass={}", plate.sensor_kg))};
  }
  updating::make_virtual_bundle(spec, folder.path() / "test");
  folder.write("test/model.bdf",
               free_plate_deck(plate.deck, plate.shells_along));
  std::ifstream in(folder.path() / "test" / "test.json");
  folder.write("test/test.json", one_run_of(json::parse(in), plate).dump());

  updating::Session session(folder.path() / "test");
  session.fit_uncertain();
  if (plate.sensor_kg > 0.0) {
    session.add(updating::parse_effect("sensor-mass"));
  }
  std::map<std::string, updating::Estimate> result;
  for (const updating::Estimate& e : session.model_parameters()) {
    result.emplace(e.name, e);
  }
  return result;
}

}  // namespace tapfit::support
