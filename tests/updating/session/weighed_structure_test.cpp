// Frequencies tell stiffness over mass: with the weight of the structure both.
#include "tests/updating/support/clamped_beam.hpp"
#include "updating/session/session.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <string>
#include <vector>

namespace tapfit::updating {
namespace {

constexpr double heavier = 1.1;  // than the deck, and as much stiffer

// E and rho of the beam, as shares of the deck's.
std::vector<Estimate> identified(const std::string& weighed) {
  const std::vector<Dof> points = testing::beam_points();
  const tapfit::testing::TemporaryFolder folder;
  testing::write_modal_bundle(
      folder,
      testing::beam_text(),
      testing::clamped_beam(points),
      points,
      {0.02, 0.1},
      R"(, "uncertain": [{"material": 1, "property": "E", "sd_percent": 30},
                         {"material": 1, "property": "rho", "sd_percent": 30}])" +
          weighed);
  Session session(folder.path());
  session.fit_uncertain();
  std::vector<Estimate> both = session.model_parameters();
  both.resize(2);
  for (Estimate& p : both) p.sd /= p.value;
  return both;
}

TEST(WeighedStructure, TellsTheModulusWithTheDensity) {
  const std::vector<Estimate> open = identified("");
  const double kg = 7850.0 * testing::beam_area;  // of 1 m
  const std::vector<Estimate> known = identified(
      fmt::format(R"(, "weighed": {{"mass_kg": {}}})", heavier * kg));
  constexpr std::array<double, 2> deck{2.1e11, 7850.0};
  for (std::size_t k = 0; k < 2; ++k) {
    // Half of a common factor's variance is that of each prior.
    EXPECT_NEAR(open[k].sd, 0.3 / std::sqrt(2.0), 0.03) << open[k].name;
    // As weighed to 1 %, and as decks are off.
    EXPECT_NEAR(known[k].sd, std::hypot(0.01, 0.025), 0.003) << known[k].name;
    EXPECT_NEAR(known[k].value / deck[k], heavier, 0.01) << known[k].name;
  }
}

}  // namespace
}  // namespace tapfit::updating
