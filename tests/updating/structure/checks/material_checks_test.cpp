#include "updating/structure/checks/material_checks.hpp"

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

TEST(MaterialChecks, PassWhatSolidsHave) {
  for (const auto& [E, rho] : {std::pair{1.05e12, 3500.0},  // diamond
                               std::pair{210e9, 7850.0},
                               std::pair{2e6, 1100.0},  // rubber
                               std::pair{2e4, 30.0},    // foam
                               std::pair{210e9, 0.0}}) {
    EXPECT_TRUE(material_unit_warnings(with_material(E, rho)).empty()) << E;
  }
}

TEST(MaterialChecks, NameOtherUnits) {
  // Steel in MPa and t/mm^3, in GPa, in MPa and kg/m^3 a thousandfold, and in
  // SI but scaled as mm-t-s.
  for (const auto& [E, rho] : {std::pair{210e3, 7.85e-9},
                               std::pair{210.0, 0.0},
                               std::pair{210e3, 7.85e6},
                               std::pair{210e15, 7850e12}}) {
    const auto texts = material_unit_warnings(with_material(E, rho));
    ASSERT_EQ(texts.size(), 1U) << E;
    EXPECT_THAT(texts[0], HasSubstr("MAT1 7"));
    EXPECT_THAT(texts[0], HasSubstr("mm-t-s"));
  }
}

TEST(MaterialChecks, NameTheCardWithoutDensity) {
  const InputError error = no_density(with_material(7e10, 0.0), "no mass");
  EXPECT_THAT(error.where(), HasSubstr("MAT1 7"));
  EXPECT_THAT(error.remedy(), HasSubstr("RHO"));
}

}  // namespace
}  // namespace tapfit::structure
