// Decks through the vectors of another's base, against their own bases.
#include "updating/reduction/deck_through_base.hpp"

#include "tests/updating/support/sample_plate.hpp"
#include "updating/reduction/reduced_base.hpp"

#include <gtest/gtest.h>

#include <utility>

namespace tapfit::updating {
namespace {

using Eigen::Index;
using Eigen::VectorXd;

class DeckThroughBase : public ::testing::Test {
 protected:
  [[nodiscard]] BaseBuilder builder(const structure::Deck& deck,
                                    bool split = false) const {
    BaseOptions options = support::plate_base(bundle_, deck);
    options.split = split;
    return {deck, bundle_.uncertain, options, Progress{}};
  }

  static VectorXd stiffness(const ReducedBase& base) {
    return base.K.diagonal();
  }

  acquisition::TestBundle bundle_ = support::plate_bundle();
  structure::Deck deck_ = support::plate_deck(true);
};

TEST_F(DeckThroughBase, OfTheSameDeckIsTheBase) {
  for (const bool split : {false, true}) {
    const BaseBuilder own = builder(deck_, split);
    const ReducedBase base = own.build({}, {}, BaseUse::Scan);
    const ReducedBase same = own.through_base(deck_);
    ASSERT_EQ(same.size(), base.size());
    ASSERT_EQ(same.part_power, base.part_power);
    const VectorXd k = stiffness(base);
    for (Index r = 0; r < 5; ++r) {
      // Rounding of products with vectors that reach a thousand times as high.
      EXPECT_NEAR(stiffness(same)(r) / k(r), 1.0, 1e-6) << r;
      EXPECT_NEAR(same.K_part[0](r, r) / base.K_part[0](r, r), 1.0, 1e-6) << r;
    }
    // Up to their signs the same shapes; the tip moves up and down.
    const VectorXd tip = base.rows.row(6 * 10 + 2).cwiseAbs();
    const VectorXd of_same = same.rows.row(6 * 10 + 2).cwiseAbs();
    EXPECT_LT((of_same - tip).head(5).norm(), 1e-5 * tip.head(5).norm());
  }
}

// Bending stiffness grows as t^3 and mass as t: frequencies double. Shear takes
// (pi t / l)^2 or so of the third mode's stiffness, l half its wave: the
// vectors have it as the thin plate does, half a thousandth.
TEST_F(DeckThroughBase, OfAPlateTwiceAsThickComesClose) {
  structure::Deck thick = deck_;
  thick.shell_properties[1].thickness *= 2.0;
  const ReducedBase found = builder(deck_).through_base(thick);
  const ReducedBase exact = builder(thick).build({}, {}, BaseUse::Scan);
  const ReducedBase thin = builder(deck_).build({}, {}, BaseUse::Scan);
  for (Index r = 0; r < 3; ++r) {
    EXPECT_NEAR(stiffness(found)(r) / stiffness(exact)(r), 1.0, 2e-3) << r;
    EXPECT_GE(stiffness(found)(r), (1.0 - 1e-8) * stiffness(exact)(r))
        << "Rayleigh";
    EXPECT_NEAR(stiffness(found)(r) / stiffness(thin)(r), 4.0, 0.2) << r;
  }
}

TEST_F(DeckThroughBase, OfModuliExchangedComesCloseFromAbove) {
  structure::Deck wood = deck_;
  structure::Material& grain = wood.materials[1];
  grain.orthotropic = true;
  grain.E = 11e9;
  grain.E2 = 5e9;
  grain.nu = 0.05;
  grain.G = 0.7e9;
  grain.rho = 430.0;
  structure::Deck turned = wood;
  std::swap(turned.materials[1].E, turned.materials[1].E2);
  const ReducedBase found = builder(wood).through_base(turned);
  const ReducedBase exact = builder(turned).build({}, {}, BaseUse::Scan);
  const ReducedBase before = builder(wood).build({}, {}, BaseUse::Scan);
  EXPECT_LT(stiffness(exact)(0), 0.6 * stiffness(before)(0));
  for (Index r = 0; r < 4; ++r) {
    const double ratio = stiffness(found)(r) / stiffness(exact)(r);
    EXPECT_GT(ratio, 1.0 - 1e-8) << r;
    EXPECT_LT(ratio, 1.03) << r;
  }
}

}  // namespace
}  // namespace tapfit::updating
