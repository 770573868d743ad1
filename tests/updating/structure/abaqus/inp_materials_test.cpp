// *ELASTIC of all types: MAT1, MAT8, MAT9 that mean the same.
#include "tests/updating/support/inp_support.hpp"

namespace tapfit::structure {
namespace {

Material solid_material(const std::string& elastic) {
  const Deck deck =
      deck_of_inp(one_brick() + "*SOLID SECTION, ELSET=V, MATERIAL=M\n" +
                  "*MATERIAL, NAME=M\n" + elastic + "*DENSITY\n500.\n");
  return deck.materials.begin()->second;
}

// D = E (1 - nu) / ((1 + nu)(1 - 2 nu)) and so on for E = 10, nu = 0.25.
TEST(InpMaterials, OrthotropicModuliOfAnIsotropicSolid) {
  const Material m = solid_material(
      "*ELASTIC, TYPE=ORTHO\n12., 4., 12., 4., 4., 12., 4., 4.,\n4.\n");
  ASSERT_TRUE(m.is_solid());
  EXPECT_NEAR(m.solid(0, 0), 12.0, 1e-12);
  EXPECT_NEAR(m.solid(0, 1), 4.0, 1e-12);
  EXPECT_NEAR(m.solid(5, 5), 4.0, 1e-12);
  EXPECT_EQ(m.rho, 500.0);
  const Material same = solid_material(
      "*ELASTIC, TYPE=ENGINEERING CONSTANTS\n"
      "10., 10., 10., .25, .25, .25, 4., 4.,\n4.\n");
  EXPECT_LT((same.solid - m.solid).norm(), 1e-8);
}

// 13 and 23 change places between the programs.
TEST(InpMaterials, ShearModuliKeepTheirPlanes) {
  const Material m = solid_material(
      "*ELASTIC, TYPE=ORTHOTROPIC\n12., 4., 12., 4., 4., 12., 1., 2.,\n3.\n");
  EXPECT_NEAR(m.solid(3, 3), 1.0, 1e-12);  // xy
  EXPECT_NEAR(m.solid(4, 4), 3.0, 1e-12);  // yz
  EXPECT_NEAR(m.solid(5, 5), 2.0, 1e-12);  // zx
}

TEST(InpMaterials, AnisotropicModuliRunColumnByColumn) {
  const Material m = solid_material(
      "*ELASTIC, TYPE=ANISO\n12., 4., 12., 4., 4., 12., .1, .2,\n"
      ".3, 4., .4, 0., 0., 0., 4., 0.,\n0., 0., 0., .5, 4.\n");
  EXPECT_NEAR(m.solid(0, 3), 0.1, 1e-12);  // 1112
  EXPECT_NEAR(m.solid(0, 5), 0.4, 1e-12);  // 1113
  EXPECT_NEAR(m.solid(4, 5), 0.5, 1e-12);  // 1323
}

TEST(InpMaterials, ShellTakesTheModuliOfASolid) {
  const Deck deck =
      deck_of_inp(one_shell() + "*SHELL SECTION, ELSET=P, MATERIAL=M\n.01\n" +
                  "*MATERIAL, NAME=M\n*ELASTIC, TYPE=ORTHO\n"
                  "12., 4., 12., 4., 4., 12., 4., 4.,\n4.\n*DENSITY\n500.\n");
  const Material& m = deck.materials.begin()->second;
  EXPECT_TRUE(m.orthotropic);
  EXPECT_NEAR(m.E, 10.0, 1e-8);
  EXPECT_NEAR(m.nu, 0.25, 1e-8);
}

TEST(InpMaterials, FirstTemperatureIsTakenAndSaid) {
  const Deck deck = deck_of_inp(
      one_brick() + "*SOLID SECTION, ELSET=V, MATERIAL=M\n" +
      "*MATERIAL, NAME=M\n*ELASTIC\n2.e11, .3, 20.\n1.e11, .3, 500.\n");
  EXPECT_EQ(deck.materials.begin()->second.E, 2e11);
  EXPECT_TRUE(warns(deck, "of the temperatures of *ELASTIC the first"));
}

TEST(InpMaterials, NamesAreSaidWithTheirIds) {
  const Deck deck = deck_of_inp(one_brick() + brick_section);
  EXPECT_TRUE(warns(deck, "an Abaqus or CalculiX deck, read as bulk data"));
  EXPECT_TRUE(warns(deck, "MAT1 1 is STEEL, PSOLID 1 is V"));
  const bool named = std::ranges::any_of(deck.cards, [](const std::string& l) {
    return l == "$ MAT1 1 is STEEL";
  });
  EXPECT_TRUE(named);
}

TEST(InpMaterials, ModuliOfNoElasticMaterialAreRefused) {
  for (const char* elastic :
       {"*ELASTIC\n-1., .3\n",
        "*ELASTIC, TYPE=ENGINEERING CONSTANTS\n1., 1., 1., .9, .9, .9, 1., "
        "1.,\n1.\n",
        "*ELASTIC, TYPE=ENGINEERING CONSTANTS\n1., 1., 0., .3, .3, .3, 1., "
        "1.,\n1.\n"}) {
    EXPECT_THAT([&] { static_cast<void>(solid_material(elastic)); },
                Refuses("the moduli of M are those of no elastic material"))
        << elastic;
  }
}

}  // namespace
}  // namespace tapfit::structure
