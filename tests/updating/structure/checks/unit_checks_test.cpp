#include "updating/structure/checks/unit_checks.hpp"

#include "acquisition/foundation/input_error.hpp"
#include "tests/support/matchers.hpp"
#include "tests/updating/support/deck_support.hpp"

namespace tapfit::structure {
namespace {

Deck with_material(double E, double rho) {
  Deck deck;
  deck.path = "model.bdf";
  deck.materials[7] = {.id = 7, .E = E, .rho = rho};
  return deck;
}

TEST(UnitChecks, PassWhatSolidsHave) {
  for (const auto& [E, rho] : {std::pair{1.05e12, 3500.0},  // diamond
                               std::pair{210e9, 7850.0},
                               std::pair{2e6, 1100.0},  // rubber
                               std::pair{2e4, 30.0},    // foam
                               std::pair{210e9, 0.0}}) {
    EXPECT_TRUE(unit_warnings(with_material(E, rho)).empty()) << E;
  }
}

TEST(UnitChecks, NameOtherUnits) {
  // Steel in MPa, in MPa and t/mm^3, in GPa, in MPa and kg/m^3 a thousandfold,
  // and in SI but scaled as mm-t-s.
  for (const auto& [E, rho] : {std::pair{210e3, 7850.0},
                               std::pair{210e3, 7.85e-9},
                               std::pair{210.0, 0.0},
                               std::pair{210e3, 7.85e6},
                               std::pair{210e15, 7850e12}}) {
    const auto texts = unit_warnings(with_material(E, rho));
    ASSERT_EQ(texts.size(), 1U) << E;
    EXPECT_THAT(texts[0], HasSubstr("MAT1 7"));
    EXPECT_THAT(texts[0], HasSubstr("mm-t-s"));
  }
}

TEST(UnitChecks, NameAShellThatIsThickerThanTheStructure) {
  Deck deck;
  deck.grids = {{1, {0, 0, 0}}, {2, {0.3, 0.4, 0}}};
  deck.shell_properties[2].thickness = 0.2;
  EXPECT_TRUE(unit_warnings(deck).empty());
  deck.shell_properties[2].thickness = 5.0;
  const auto texts = unit_warnings(deck);
  ASSERT_EQ(texts.size(), 1U);
  EXPECT_THAT(texts[0], HasSubstr("PSHELL 2"));
  EXPECT_THAT(texts[0], HasSubstr("0.5 m"));
}

TEST(UnitChecks, NameTheCardWithoutDensity) {
  const InputError error = no_density(with_material(7e10, 0.0), "no mass");
  EXPECT_THAT(error.where(), HasSubstr("MAT1 7"));
  EXPECT_THAT(error.remedy(), HasSubstr("RHO"));
}

}  // namespace
}  // namespace tapfit::structure
