// Degrees of freedom that are held though no constraint names them.
#include "acquisition/foundation/input_error.hpp"
#include "tests/support/matchers.hpp"
#include "tests/updating/support/deck_support.hpp"
#include "updating/structure/assembly/assemble.hpp"
#include "updating/structure/assembly/deck_modes.hpp"

#include <cmath>
#include <numbers>

namespace tapfit::structure {
namespace {

DeckModes solved(const Deck& deck, Eigen::Index count = 20) {
  return deck_modes(deck, assemble(deck), count);
}

// A mass on springs: f = sqrt(k / m) / (2 pi) in each direction.
TEST(HeldDofs, SoftSpringBesideAStiffOneIsKept) {
  const Deck deck = deck_of(
      "GRID,1,,0.,0.,0.\nCONM2,9,1,,2.\nCELAS2,1,1.+10,1,1\n"
      "CELAS2,2,1.+10,1,2\nCELAS2,3,50.,1,3\n");
  const DeckModes found = solved(deck);
  ASSERT_EQ(found.modes.frequency_hz.size(), 3);
  const double expected = std::sqrt(50.0 / 2.0) / (2.0 * std::numbers::pi);
  EXPECT_NEAR(found.modes.frequency_hz(0), expected, 1e-6 * expected);
  EXPECT_TRUE(found.warnings.empty());
}

TEST(HeldDofs, SoftBushAndTurnedAxesAreKept) {
  // Stiff along the turned x and y, soft along the turned z.
  const Deck deck = deck_of(
      "CORD2R,5,,0.,0.,0.,1.,1.,1.\n,1.,0.,0.\nGRID,1,,0.,0.,0.,5\n"
      "CONM2,9,1,,2.\nPBUSH,4,K,1.+10,1.+10,50.\nCBUSH,1,4,1,,,,,5\n"
      "SPC1,1,456,1\n");
  const DeckModes found = solved(deck);
  ASSERT_EQ(found.modes.frequency_hz.size(), 3);
  const double expected = std::sqrt(50.0 / 2.0) / (2.0 * std::numbers::pi);
  EXPECT_NEAR(found.modes.frequency_hz(0), expected, 1e-4 * expected);
}

TEST(HeldDofs, MassWithoutStiffnessIsNamed) {
  const Deck deck = deck_of(
      "GRID,1,,0.,0.,0.\nGRID,2,,1.,0.,0.\nCONM2,9,2,,2.\n"
      "MAT1,1,7.+10,,.3\nPROD,2,1,1.-4\nCROD,1,2,1,2\nSPC1,1,123456,1\n");
  const DeckModes found = solved(deck);
  EXPECT_EQ(found.modes.frequency_hz.size(), 1);
  ASSERT_EQ(found.warnings.size(), 1U);
  EXPECT_THAT(found.warnings[0], HasSubstr("2 degrees of freedom with mass"));
  EXPECT_THAT(found.warnings[0],
              HasSubstr("component 2 of 1 grid, component 3 of 1 grid; first "
                        "GRID 2 (model.bdf:2), component 2"));
  // Held on purpose: nothing to say.
  Deck meant = deck;
  meant.constraints.push_back({2, "23"});
  EXPECT_TRUE(solved(meant).warnings.empty());
}

TEST(HeldDofs, RodWithoutAreaIsNamed) {
  const Deck deck = deck_of(
      "GRID,1,,0.,0.,0.\nGRID,2,,1.,0.,0.\nCONM2,9,2,,2.\n"
      "MAT1,1,7.+10,,.3,2700.\nPROD,2,1\nCROD,1,2,1,2\n");
  ASSERT_FALSE(deck.warnings.empty());
  EXPECT_THAT(deck.warnings[0],
              HasSubstr("model.bdf:5 PROD 2: no A, the rods neither resist"));
}

TEST(HeldDofs, VeryThinPlateStillBends) {
  // Frequencies of a plate go with its thickness, however thin it is.
  Plate plate;
  plate.shear = false;
  const auto first = [&](double thickness) {
    plate.thickness = thickness;
    Deck deck = plate_deck(plate, 6, 6);
    hold(deck, "123456", [](const Eigen::Vector3d& p) { return p.x() == 0.0; });
    const DeckModes found = solved(deck, 1);
    EXPECT_TRUE(found.warnings.empty()) << found.warnings[0];
    return found.modes.frequency_hz(0) / thickness;
  };
  EXPECT_NEAR(first(3e-6) / first(1e-3), 1.0, 1e-3);
}

TEST(HeldDofs, PropertyWithoutBendingIsNamed) {
  const std::string grids =
      "GRID,1,,0.,0.,0.\nGRID,2,,1.,0.,0.\nGRID,3,,1.,1.,0.\n"
      "GRID,4,,0.,1.,0.\nMAT1,1,7.+10,,.3,2700.\n";
  const Deck plate = deck_of(grids + "PSHELL,1,1,0.01\nCQUAD4,5,1,1,2,3,4\n");
  ASSERT_EQ(plate.warnings.size(), 1U);
  EXPECT_THAT(plate.warnings[0], HasSubstr("model.bdf:6 PSHELL 1: no MID2"));
  EXPECT_THAT(solved(plate).warnings.at(0),
              HasSubstr("component 3 of 4 grids"));
  const Deck bar = deck_of(grids + "PBAR,2,1,1.-4\nCBAR,5,2,1,2,0.,0.,1.\n");
  EXPECT_THAT(bar.warnings.back(), HasSubstr("model.bdf:6 PBAR 2: no I1, I2"));
  // A property that nothing uses lacks nothing.
  EXPECT_TRUE(deck_of(grids + "PSHELL,1,1,0.01,1\nCQUAD4,5,1,1,2,3,4\n"
                              "PBAR,2,1,1.-4\n")
                  .warnings.empty());
}

// Simply supported in no way: the free Bernoulli beam, f1 L^2 =
// 22.3733 sqrt(EI / m) / (2 pi), also where the line lies askew.
TEST(HeldDofs, FreeLineOfBarsSolvesThoughItsTwistHasNoInertia) {
  for (const bool coupled : {false, true}) {
    for (const bool askew : {false, true}) {
      const int n = 20;
      Deck deck;
      deck.coupled_mass = coupled;
      deck.materials[1] = {1, false, 70e9, 0.3, 70e9 / 2.6, 2700.0, 0, 0, 0};
      deck.bar_properties[1] = {1, 1, 4e-4, 1.3e-8, 2.6e-8, 0.0, 3e-8};
      const Eigen::Vector3d along =
          askew ? Eigen::Vector3d(1.0, 2.0, 0.5).normalized()
                : Eigen::Vector3d(1.0, 0.0, 0.0);
      for (int i = 0; i <= n; ++i) {
        deck.grids.push_back({i + 1, along * i / n});
        if (i > 0) deck.bars.push_back(make_bar(i, 1, i, i + 1));
      }
      const DeckModes found = solved(deck, 8);
      // Six of the body less the twist, then bending in the softer plane.
      const double expected = 22.3733 / (2.0 * std::numbers::pi) *
                              std::sqrt(70e9 * 1.3e-8 / (2700.0 * 4e-4));
      EXPECT_LT(found.modes.frequency_hz(4), 0.01);
      EXPECT_NEAR(found.modes.frequency_hz(5),
                  expected,
                  (coupled ? 1e-4 : 2e-2) * expected)
          << coupled << askew;
      ASSERT_EQ(found.warnings.size(), 1U) << found.warnings.at(1);
      EXPECT_THAT(found.warnings[0], HasSubstr("1 turn without inertia"));
      EXPECT_THAT(found.warnings[0], HasSubstr("CBEAM"));
    }
  }
}

TEST(HeldDofs, TwistThatASpringOrAMassHoldsIsKept) {
  const std::string bars =
      "GRID,1,,0.,0.,0.\nGRID,2,,1.,0.,0.\nGRID,3,,2.,0.,0.\n"
      "MAT1,1,7.+10,,.3,2700.\nPBAR,2,1,1.-4,1.-9,2.-9,3.-9\n"
      "CBAR,21,2,1,2,0.,0.,1.\nCBAR,22,2,2,3,0.,0.,1.\n";
  EXPECT_EQ(solved(deck_of(bars)).warnings.size(), 1U);
  EXPECT_TRUE(solved(deck_of(bars + "CELAS2,31,1.,1,4\n")).warnings.empty());
  EXPECT_TRUE(solved(deck_of(bars + "SPC1,1,4,3\n")).warnings.empty());
  const DeckModes inertia = solved(deck_of(
      bars + "CONM2,31,1\n,1.-3\nCONM2,32,3\n,1.-3\nSPC1,1,12356,1,2,3\n"));
  // Two wheels on a shaft: f = sqrt(2 k / I) / (2 pi), k = GJ / 2.
  const double k = 7e10 / 2.6 * 3e-9 / 2.0;
  EXPECT_TRUE(inertia.warnings.empty());
  ASSERT_EQ(inertia.modes.frequency_hz.size(), 2);
  EXPECT_NEAR(inertia.modes.frequency_hz(1),
              std::sqrt(2.0 * k / 1e-3) / (2.0 * std::numbers::pi),
              1e-3);
}

}  // namespace
}  // namespace tapfit::structure
