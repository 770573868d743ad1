// What `tapfit model` takes a deck's numbers for.
#include "tests/acquisition/support/temporary_folder.hpp"
#include "tui/commands/commands.hpp"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

namespace tapfit::tui {
namespace {

// A bar of steel, 1 m long and 1 cm thick, in millimetres and tonnes: the same
// frequencies, and its mass in kilograms.
TEST(ModelCommand, TakesTheUnitsOfADeck) {
  testing::TemporaryFolder folder;
  CommandOptions options;
  options.input = folder.write(
      "bar.bdf",
      "GRID,1,,0.,0.,0.,,123456\nGRID,2,,500.,0.,0.\nGRID,3,,1000.,0.,0.\n"
      "CBAR,1,1,1,2,0.,0.,1.\nCBAR,2,1,2,3,0.,0.,1.\n"
      "PBAR,1,1,100.,833.,833.,1400.\nMAT1,1,210000.,,.3,7.85-9\n");
  options.json = true;
  options.modes = 3;
  const auto plain = nlohmann::json::parse(model_command(options, {}));
  options.units = "mm-t-s";
  const auto scaled = nlohmann::json::parse(model_command(options, {}));
  EXPECT_NEAR(scaled["mass_kg"].get<double>(), 0.785, 1e-9);
  EXPECT_NEAR(plain["mass_kg"].get<double>(), 0.785e-3, 1e-12);
  const double hz = plain["frequencies_hz"][0];
  EXPECT_NEAR(scaled["frequencies_hz"][0].get<double>(), hz, 1e-9 * hz);
  EXPECT_LT(scaled["warnings"].size(), plain["warnings"].size());
}

}  // namespace
}  // namespace tapfit::tui
