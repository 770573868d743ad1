#include "updating/reduction/reduced_base.hpp"

#include "acquisition/foundation/constants.hpp"
#include "acquisition/foundation/input_error.hpp"
#include "tests/updating/support/deck_support.hpp"
#include "updating/structure/assembly/assemble.hpp"
#include "updating/structure/assembly/deck_modes.hpp"
#include "updating/structure/solve/eigenmodes.hpp"
#include "updating/structure/solve/factor.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace tapfit::updating {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;

// A strip clamped at x = 0, 8 by 3 elements.
structure::Deck strip() {
  structure::Plate plate;
  plate.a = 0.4;
  plate.b = 0.15;
  plate.thickness = 0.004;
  structure::Deck deck = structure::plate_deck(plate, 8, 3);
  for (int j = 1; j <= 4; ++j) deck.constraints.push_back({j, "123456"});
  return deck;
}

// One component of every grid that moves.
std::vector<int> points_along(const structure::Deck& deck, int component) {
  std::vector<int> points;
  for (std::size_t k = 4; k < deck.grids.size(); ++k) {
    points.push_back(6 * static_cast<int>(k) + component - 1);
  }
  return points;
}

struct Whole {
  structure::System system;
  std::vector<int> free;
  structure::SparseMatrix K;
  structure::SparseMatrix M;
};

Whole whole(const structure::Deck& deck) {
  Whole w;
  w.system = structure::assemble(deck);
  w.free = w.system.free_dofs();
  w.K = structure::extract(w.system.K, w.free);
  w.M = structure::extract(w.system.M, w.free);
  return w;
}

ReducedBase base_of(const structure::Deck& deck,
                    double high_hz,
                    const std::vector<int>& points) {
  BaseOptions options;
  options.high_hz = high_hz;
  options.split = false;
  options.points = points;
  return BaseBuilder(deck, {}, options, Progress{}).build({}, {});
}

// In its own plane a plate is so stiff that all static responses look like the
// first mode: the basis must not trade the mode for what little they differ.
TEST(ReducedBase, KeepsItsModesBesideNearlyEqualResponses) {
  const structure::Deck deck = strip();
  const Whole w = whole(deck);
  const Eigen::VectorXd hz =
      structure::eigenmodes_up_to(w.K, w.M, 1000.0).frequency_hz;
  for (const int component : {1, 2, 3}) {
    const ReducedBase base =
        base_of(deck, 1000.0, points_along(deck, component));
    for (Index k = 0; k < hz.size(); ++k) {
      // Rounding of K over the stiffest direction of the basis.
      EXPECT_NEAR(std::sqrt(base.K(k, k)) / two_pi, hz(k), 1e-6 * hz(k))
          << "component " << component << ", mode " << k + 1;
    }
  }
}

// Receptances of a direct solve of the whole model, off resonance.
TEST(ReducedBase, ItsResponsesAreThoseOfTheWholeModel) {
  const structure::Deck deck = strip();
  const Whole w = whole(deck);
  constexpr double high_hz = 800.0;
  for (const int component : {2, 3}) {
    const std::vector<int> all = points_along(deck, component);
    const std::vector<int> points = {all.front(), all[13], all.back()};
    const ReducedBase base = base_of(deck, high_hz, points);
    for (const double hz : {3.0, 55.0, 210.0, 470.0, 790.0}) {
      const double w2 = std::pow(two_pi * hz, 2);
      const structure::Factor factor(w.K - w2 * w.M);
      for (const int from : points) {
        Eigen::VectorXd force = Eigen::VectorXd::Zero(w.K.rows());
        const auto place = [&](int dof) {
          return std::lower_bound(w.free.begin(), w.free.end(), dof) -
                 w.free.begin();
        };
        force(place(from)) = 1.0;
        const MatrixXd direct = factor.solve(force);
        const Eigen::VectorXd reduced =
            base.rows * (base.K.diagonal().array() - w2)
                            .inverse()
                            .matrix()
                            .cwiseProduct(base.rows.row(from).transpose());
        for (const int at : points) {
          const double H = direct(place(at), 0);
          // What the basis is made for, see response_orders.
          EXPECT_NEAR(reduced(at), H, 1e-6 * std::abs(H))
              << hz << " Hz, component " << component;
        }
      }
    }
  }
}

// The clamped strip and a plate beside it that nothing holds.
structure::Deck strip_and_loose_plate() {
  structure::Deck deck = strip();
  const int first = static_cast<int>(deck.grids.size()) + 1;
  for (const double x : {1.0, 1.2}) {
    for (const double y : {0.0, 0.1}) {
      deck.grids.push_back(
          {static_cast<int>(deck.grids.size()) + 1, {x, y, 0.0}});
    }
  }
  deck.shells.push_back({1000, 1, {first, first + 2, first + 3, first + 1}});
  return deck;
}

TEST(ReducedBase, NamesALoosePartAsTheModelsModesDo) {
  const structure::Deck deck = strip_and_loose_plate();
  BaseOptions options;
  options.high_hz = 300.0;
  options.split = false;
  const std::vector<std::string> said =
      BaseBuilder(deck, {}, options, {}).warnings();
  ASSERT_EQ(said.size(), 1U);
  EXPECT_NE(said[0].find("6 motions without stiffness"), std::string::npos);
  EXPECT_EQ(
      said,
      structure::deck_modes(deck, structure::assemble(deck), 10).warnings);
  EXPECT_TRUE(BaseBuilder(strip(), {}, options, {}).warnings().empty());
}

// A bar alone turns about its axis without stiffness or inertia; split it has
// a grid more, which is not in the deck and must not be named.
TEST(ReducedBase, NamesAGridOfTheDeckWhereNothingHoldsIt) {
  structure::Deck deck = strip();
  const int id = static_cast<int>(deck.grids.size()) + 1;
  deck.grids.push_back({id, {1.0, 0.0, 0.0}});
  deck.grids.push_back({id + 1, {1.2, 0.0, 0.0}});
  structure::ScalarElement spring;
  spring.id = 1000;
  spring.grids = {id, id + 1};
  spring.components = {1, 1};
  spring.stiffness = 1e6;
  deck.scalars.push_back(spring);
  const auto message = [](const auto& run) {
    try {
      run();
    } catch (const InputError& error) {
      return std::string(error.what());
    }
    return std::string("no error");
  };
  const std::string expected =
      message([&] { structure::name_mechanism(deck); });
  EXPECT_NE(expected.find("component 1"), std::string::npos) << expected;
  for (const bool split : {false, true}) {
    BaseOptions options;
    options.high_hz = 300.0;
    options.split = split;
    EXPECT_EQ(message([&] { BaseBuilder(deck, {}, options, {}); }), expected);
  }
}

}  // namespace
}  // namespace tapfit::updating
