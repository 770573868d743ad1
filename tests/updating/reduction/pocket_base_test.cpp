// A thinned member through the base against the deck that is thinner there.
#include "tests/updating/support/deck_support.hpp"
#include "updating/places/location.hpp"
#include "updating/reduction/reduced_base.hpp"
#include "updating/structure/deck/bar_thickness.hpp"

#include <Eigen/Eigenvalues>
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>

namespace tapfit::updating {
namespace {

// A flat cantilever that bends in both planes, twists by a cross bar at its tip
// and stretches.
structure::Deck flat_bar() {
  std::string text = "MAT1,1,2.1+11,,.3,7800.\nSPC1,1,123456,1\n";
  for (int k = 0; k <= 8; ++k) {
    text += fmt::format("GRID,{},,{:.3f},0.,0.\n", k + 1, 0.05 * k);
  }
  for (int k = 1; k <= 8; ++k) {
    text += fmt::format("CBAR,{},1,{},{},0.,0.,1.\n", k, k, k + 1);
  }
  text +=
      "GRID,20,,.4,.1,0.\nCBAR,9,1,9,20,0.,0.,1.\n"
      "PBAR,1,1,1.5-4,4.5-10,7.8-9,1.5-9\n";
  return structure::deck_of(text);
}

TEST(PocketBase, HasTheModesOfAThinnerBar) {
  const structure::Deck deck = flat_bar();
  BaseOptions options;
  options.high_hz = 900.0;
  options.split = false;
  for (const int grid : {6, 9, 20}) {
    const int first = 6 * static_cast<int>(deck.grid_index(grid));
    options.points.insert(options.points.end(), {first + 1, first + 2});
  }
  const BaseBuilder builder(deck, {}, options, Progress{});
  StiffnessChange change;
  change.of = {"stiffness-loss", {}};
  change.of.where.elements = {3, 4};
  change.of.where.variant = pocket;
  const ReducedBase base = builder.build({}, {change});
  const double twist = structure::twist_by_thickness(deck.bar_properties.at(1));
  for (const double c : {1.0, 0.9, 0.6}) {
    structure::Deck thin = deck;
    structure::BarProperty& own = thin.bar_properties[2] =
        thin.bar_properties.at(1);
    own.area *= c;
    own.I1 *= c * c * c;
    own.I2 *= c;
    own.J *= c * c * c + twist * (c - c * c * c);
    for (structure::Bar& bar : thin.bars) {
      if (bar.id == 3 || bar.id == 4) bar.property = 2;
    }
    const auto [K, M] = base.at({}, {c * c * c});
    const Eigen::VectorXd omega =
        Eigen::GeneralizedSelfAdjointEigenSolver<Eigen::MatrixXd>(K, M)
            .eigenvalues()
            .cwiseSqrt();
    const Eigen::VectorXd f = structure::modes_of(thin, 6).frequency_hz;
    for (Eigen::Index k = 0; k < f.size() && f(k) < options.high_hz; ++k) {
      // As loss_modes() is good to where half of the stiffness is left, and
      // more.
      EXPECT_NEAR(omega(k) / (2.0 * M_PI) / f(k), 1.0, 1e-4)
          << "mode " << k + 1 << " at " << c;
    }
  }
}

}  // namespace
}  // namespace tapfit::updating
