#include "updating/properties/line_mass.hpp"

#include "acquisition/foundation/constants.hpp"
#include "tests/updating/support/deck_support.hpp"
#include "updating/structure/assembly/assemble.hpp"
#include "updating/structure/solve/eigenmodes.hpp"
#include "updating/structure/solve/free_motions.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace tapfit::updating {
namespace {

constexpr double length = 0.4;
constexpr double width = 0.03;
constexpr double height = 0.02;
constexpr double E = 2.1e11;
constexpr double nu = 0.3;
constexpr double rho = 7850.0;
constexpr double J = 4.7e-8;
constexpr int elements = 40;

// Along x; `held` are SPC cards.
structure::Deck bar(const std::string& card, const std::string& held) {
  std::string text = "BEGIN BULK\nPARAM,COUPMASS,1\n";
  for (int i = 0; i <= elements; ++i) {
    text += fmt::format("GRID,{},,{},0.,0.\n", i + 1, length * i / elements);
  }
  for (int i = 1; i <= elements; ++i) {
    text += fmt::format("{},{},1,{},{},0.,0.,1.\n", card, i, i, i + 1);
  }
  const std::string section = fmt::format("{},{}",
                                          width * std::pow(height, 3) / 12.0,
                                          height * std::pow(width, 3) / 12.0);
  text +=
      card == "CBAR"
          ? fmt::format("PBAR,1,1,{},{},{}\n", width * height, section, J)
          : fmt::format("PBEAM,1,1,{},{},,{}\n", width * height, section, J);
  text += fmt::format("MAT1,1,{},,{},{}\n", E, nu, rho);
  return structure::deck_of(text + held + "ENDDATA\n");
}

double first_hz(const structure::Deck& deck) {
  const structure::System system = structure::assemble(deck);
  const structure::FreeMotions motions = structure::free_motions(system);
  return structure::eigenmodes(
             motions.reduce(system.K), motions.reduce(system.M), 1)
      .frequency_hz(0);
}

// Held at one end, twisting: f = sqrt(GJ / (rho (I1 + I2))) / (4 L).
TEST(LineMass, TwistsAsAShaftDoes) {
  const structure::Deck deck =
      without_line_mass(bar("CBAR", "SPC1,1,4,1\nSPC1,1,12356,1,THRU,41\n"));
  const double G = E / (2.0 * (1.0 + nu));
  const double polar =
      width * height * (width * width + height * height) / 12.0;
  const double hz = std::sqrt(G * J / (rho * polar)) / (4.0 * length);
  // Consistent masses of 40 elements: (pi / 2 / 40)^2 / 24 too high.
  EXPECT_NEAR(first_hz(deck), hz, 1e-4 * hz);
}

// On two hinges: omega^2 = EI b^4 / (rho A + rho I b^2), b = pi / L (Rayleigh).
TEST(LineMass, BendsAsRayleighsBar) {
  const std::string hinges = "SPC1,1,1246,1,THRU,41\nSPC1,1,3,1,41\n";
  const double b = std::numbers::pi / length;
  const double radius = height * height / 12.0;
  const double line = std::sqrt(E * radius / rho) * b * b / two_pi;
  const structure::Deck deck = bar("CBAR", hinges);
  EXPECT_NEAR(first_hz(deck), line, 1e-5 * line);
  const double turning = line / std::sqrt(1.0 + radius * b * b);
  EXPECT_NEAR(first_hz(without_line_mass(deck)), turning, 1e-5 * line);
}

TEST(LineMass, IsOfBarsWhoseSectionsDoNotTurn) {
  EXPECT_TRUE(has_line_mass(bar("CBAR", "")));
  EXPECT_FALSE(has_line_mass(bar("CBEAM", "")));
}

// A CBEAM that ends inside another one counts twice all the same.
TEST(LineMass, IsOfBarsThatEndInsideOthers) {
  const std::string branch =
      fmt::format("GRID,99,,{},.1,0.\nCBEAM,99,1,{},99,0.,0.,1.\n",
                  0.5 * length,
                  elements / 2 + 1);
  EXPECT_FALSE(has_line_mass(bar("CBEAM", "")));
  EXPECT_TRUE(has_line_mass(bar("CBEAM", branch)));
}

}  // namespace
}  // namespace tapfit::updating
