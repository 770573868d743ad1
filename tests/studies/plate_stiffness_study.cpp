// Do the intervals of a plate's moduli hold the truth? Plates of spruce whose
// true moduli, density and sensors' mass are drawn anew, identified from one
// hammer test each; prints every estimate in units of its standard deviation,
// and the share of the 95 % intervals that hold.
//
//   plate_stiffness_study [PLATES] [FIRST SEED] [UPPER HZ] [SENSOR KG]
//     [MASS KNOWN] [SHELLS ALONG]
#include "acquisition/foundation/seeded_random.hpp"
#include "tests/updating/support/free_plate.hpp"

#include <fmt/format.h>

#include <cmath>
#include <cstdlib>
#include <map>
#include <string>

int main(int argc, char** argv) {
  using tapfit::support::PlateTest;
  const auto argument = [&](int k, double standard) {
    return argc > k ? std::strtod(argv[k], nullptr) : standard;
  };
  const int plates = static_cast<int>(argument(1, 20));
  const auto first = static_cast<std::uint64_t>(argument(2, 1));
  const double upper = argument(3, 600.0);
  const double sensor_kg = argument(4, 0.0);
  const bool mass_known = argument(5, 0.0) > 0.0;
  const int shells = static_cast<int>(argument(6, 16));
  struct Count {
    int inside = 0;
    int all = 0;
    double error2 = 0.0;
    double sd2 = 0.0;
    double score2 = 0.0;
  };
  std::map<std::string, Count> counts;
  for (int k = 0; k < plates; ++k) {
    std::mt19937_64 random(first + static_cast<std::uint64_t>(k));
    std::uniform_real_distribution<double> off(0.88, 1.12);
    const std::map<std::string, double> truth = {
        {"E1:1", 1.1e10 * off(random)},
        {"E2:1", 0.85e9 * off(random)},
        {"G12:1", 0.72e9 * off(random)},
        {"rho:1", 410.0 * off(random)},
        {"sensor-mass mass_kg", sensor_kg}};
    PlateTest test;
    test.truth =
        fmt::format("MAT8,1,{:.8g},{:.8g},.4,{:.8g},.75+9,.1+9,{:.8g}\n",
                    truth.at("E1:1"),
                    truth.at("E2:1"),
                    truth.at("G12:1"),
                    truth.at("rho:1"));
    test.deck = fmt::format("MAT8,1,1.1+10,.85+9,.4,.72+9,.75+9,.1+9,{:.8g}\n",
                            mass_known ? truth.at("rho:1") : 410.0);
    test.properties = {"E1", "E2", "G12"};
    if (!mass_known) test.properties.push_back("rho");
    test.seed = first + static_cast<std::uint64_t>(k);
    test.sensor_kg = sensor_kg;
    test.band_hz = {50.0, upper};
    test.shells_along = shells;
    fmt::print("{:4}", test.seed);
    for (const auto& [name, e] : tapfit::support::identify_plate(test)) {
      const auto at = truth.find(name);
      if (at == truth.end()) continue;
      const double error = (e.value - at->second) / at->second;
      const double sd = e.sd / at->second;
      Count& count = counts[name];
      ++count.all;
      count.inside += at->second >= e.lo95 && at->second <= e.hi95 ? 1 : 0;
      count.error2 += error * error;
      count.sd2 += sd * sd;
      count.score2 += error * error / (sd * sd);
      fmt::print("  {} {:+.2f} sd {:.2f} %", name, 100 * error, 100 * sd);
    }
    fmt::print("\n");
    std::fflush(stdout);
  }
  for (const auto& [name, count] : counts) {
    fmt::print(
        "{}: {} of {} intervals hold, rms error {:.2f} %, sd {:.2f} %, "
        "error / sd {:.2f}\n",
        name,
        count.inside,
        count.all,
        100 * std::sqrt(count.error2 / count.all),
        100 * std::sqrt(count.sd2 / count.all),
        std::sqrt(count.score2 / count.all));
  }
}
