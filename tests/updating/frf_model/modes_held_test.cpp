// What is held, through the modes of what is free, against closed forms and
// against decks that hold it.
#include "updating/frf_model/modes_held.hpp"

#include "tests/updating/support/deck_support.hpp"
#include "tests/updating/support/sample_plate.hpp"
#include "tests/updating/support/twisting_frame.hpp"
#include "updating/frf_model/frf_model.hpp"
#include "updating/reduction/reduced_base.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <complex>
#include <numbers>
#include <string>
#include <vector>

namespace tapfit::updating {
namespace {

using Eigen::Index;
using Eigen::MatrixXcd;
using Eigen::MatrixXd;
using Eigen::VectorXcd;
using Eigen::VectorXd;

constexpr double two_pi_of = 2.0 * std::numbers::pi;

// Of a base without terms: its coordinates are its modes.
BaseModes own_modes(const ReducedBase& base) {
  return solve_modes(base.K, MatrixXd::Identity(base.size(), base.size()));
}

HeldRows held_in(const ReducedBase& base,
                 const std::vector<std::size_t>& grids,
                 const std::string& components) {
  HeldRows rows{MatrixXd(0, base.size()), MatrixXd(0, base.size())};
  for (const std::size_t grid : grids) {
    const MatrixXd all = base.rows.rows_of_grid(grid);
    for (const char digit : components) {
      MatrixXd& of = digit <= '3' ? rows.moved : rows.turned;
      of.conservativeResize(of.rows() + 1, base.size());
      of.bottomRows(1) = all.row(digit - '1');
    }
  }
  return rows;
}

// A steel beam of 1 m in 40 bars that bends in one plane and hangs free, with
// ten elastic modes below 13 kHz.
structure::Deck free_beam() {
  structure::Deck deck;
  deck.path = "beam.bdf";
  deck.coupled_mass = true;
  deck.materials[1] = {1, false, 210e9, 0.3, 210e9 / 2.6, 7800, 0, 0, 0};
  deck.bar_properties[1] = {1, 1, 4e-4, 3e-8, 1e-8, 0.0, 2e-8};
  for (int i = 0; i <= 40; ++i) {
    deck.grids.push_back({i + 1, {0.025 * i, 0.0, 0.0}});
    deck.constraints.push_back({i + 1, "1246"});
  }
  for (int i = 1; i <= 40; ++i) {
    deck.bars.push_back(structure::make_bar(i, 1, i, i + 1));
  }
  return deck;
}

// f = (lambda / L)^2 sqrt(E I / rho A) / 2 pi, lambda the roots of the beam's
// characteristic equation (Blevins, "Formulas for Natural Frequency and Mode
// Shape", 1979, table 8-1).
void expect_roots(const std::vector<std::size_t>& grids,
                  const std::string& components,
                  const std::vector<double>& roots,
                  double tolerance) {
  const structure::Deck deck = free_beam();
  BaseOptions options;
  options.high_hz = 2200.0;  // five elastic modes of the free beam
  options.split = false;
  options.points = {6 * 20 + 2, 6 * 8 + 2};
  const ReducedBase base =
      BaseBuilder(deck, {}, options, Progress{}).build({}, {});
  const BaseModes held = modes_held(own_modes(base),
                                    held_in(base, grids, components),
                                    two_pi_of * options.high_hz);
  const double unit = std::sqrt(210e9 * 3e-8 / (7800 * 4e-4));
  for (std::size_t k = 0; k < roots.size(); ++k) {
    EXPECT_NEAR(
        held.omega(static_cast<Index>(k)) / (roots[k] * roots[k] * unit),
        1.0,
        tolerance)
        << k;
  }
}

TEST(ModesHeld, OfABeamAreThoseOfACantilever) {
  expect_roots({0}, "35", {1.87510, 4.69409, 7.85476, 10.99554}, 0.03);
}

TEST(ModesHeld, OfABeamAreThoseOfOneHeldAtBothEnds) {
  expect_roots({0, 40}, "35", {4.73004, 7.85320, 10.99561}, 0.05);
}

TEST(ModesHeld, OfABeamAreThoseOfOneOnHinges) {
  using std::numbers::pi;
  expect_roots({0, 40}, "3", {pi, 2.0 * pi, 3.0 * pi}, 0.01);
}

// The base ends with motions at a million hertz that turn the clamped grid a
// lot: they are none of what the band turns there.
TEST(ModesHeld, OfAFrameThatTwistsAreThoseOfADeckThatHoldsIt) {
  BaseOptions options;
  options.high_hz = 700.0;
  options.points = {20, 32, 44, 68};
  const auto base_of = [&options](bool clamped) {
    return BaseBuilder(
               testing::twisting_frame(clamped), {}, options, Progress{})
        .build({}, {});
  };
  const ReducedBase base = base_of(false);
  const BaseModes held = modes_held(own_modes(base),
                                    held_in(base, {0}, "123456"),
                                    two_pi_of * options.high_hz);
  const VectorXd clamped = own_modes(base_of(true)).omega;
  for (Index k = 0; k < 6; ++k) {
    EXPECT_NEAR(held.omega(k) / clamped(k), 1.0, 0.1) << k;
  }
}

// The sample plate, held by its deck and held through the free one's modes.
class HeldPlate : public ::testing::Test {
 protected:
  struct Modes {
    VectorXd omega;
    MatrixXd shape;  // at the points of the test, points x modes
  };

  // Its deck, free but for components at grids.
  static Modes solved(const std::vector<int>& nodes,
                      const std::string& components) {
    const acquisition::TestBundle bundle = support::plate_bundle();
    structure::Deck deck = support::plate_deck(false);
    for (const int node : nodes) deck.constraints.push_back({node, components});
    BaseOptions options = support::plate_base(bundle, deck);
    options.high_hz = high_hz;
    const BaseBuilder builder(deck, {}, options, Progress{});
    const ReducedBase base = builder.build({}, {});
    return seen(base, own_modes(base), options);
  }

  static Modes through_the_free_one(const std::vector<int>& nodes,
                                    const std::string& components) {
    const acquisition::TestBundle bundle = support::plate_bundle();
    const structure::Deck deck = support::plate_deck(false);
    BaseOptions options = support::plate_base(bundle, deck);
    options.high_hz = high_hz;
    const BaseBuilder builder(deck, {}, options, Progress{});
    const ReducedBase base = builder.build({}, {});
    std::vector<std::size_t> grids;
    for (const int node : nodes) grids.push_back(deck.grid_index(node));
    return seen(base,
                modes_held(own_modes(base),
                           held_in(base, grids, components),
                           two_pi_of * high_hz),
                options);
  }

  static Modes seen(const ReducedBase& base,
                    const BaseModes& modes,
                    const BaseOptions& options) {
    Modes result{modes.omega,
                 MatrixXd(std::ssize(options.points), modes.omega.size())};
    for (std::size_t k = 0; k < options.points.size(); ++k) {
      result.shape.row(static_cast<Index>(k)) =
          base.rows.row(options.points[k]) * modes.phi;
    }
    return result;
  }

  // Accelerances between all points on the line s = omega (0.06 + j), each line
  // over its mean, modes damped by 0.8 %.
  static MatrixXcd frfs(const Modes& modes) {
    constexpr int lines = 60;
    const Index n = modes.shape.rows();
    MatrixXcd H(lines, n * n);
    for (Index l = 0; l < lines; ++l) {
      const double share = static_cast<double>(l) / (lines - 1);
      const double w = two_pi_of * (20.0 + (high_hz - 20.0) * share);
      const std::complex<double> s(0.06 * w, w);
      const VectorXcd g = modes.omega.unaryExpr([s](double own) {
        return s * s / (s * s + 0.016 * own * s + own * own);
      });
      const MatrixXcd all =
          modes.shape * g.asDiagonal() * modes.shape.transpose();
      H.row(l) = all.reshaped().transpose();
    }
    return H;
  }

  static double error(const MatrixXcd& H, const MatrixXcd& measured) {
    const VectorXd level = measured.rowwise().norm();
    return std::sqrt(((H - measured).rowwise().squaredNorm().array() /
                      level.array().square())
                         .mean());
  }

  static constexpr double high_hz = 1000.0;
};

struct Held {
  std::string name;
  std::vector<int> nodes;
  std::string components;
};

const std::vector<Held>& all_held() {
  static const std::vector<Held> all = {
      {"left end", {1, 12, 23, 34, 45}, "123456"},
      {"right end", {11, 22, 33, 44, 55}, "123456"},
      {"left hinge", {1, 12, 23, 34, 45}, "123"},
      {"right hinge", {11, 22, 33, 44, 55}, "123"},
      {"front", {1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11}, "123456"},
      {"back", {45, 46, 47, 48, 49, 50, 51, 52, 53, 54, 55}, "123456"},
      {"both ends", {1, 12, 23, 34, 45, 11, 22, 33, 44, 55}, "123456"},
      {"corners", {1, 11, 45, 55}, "123"}};
  return all;
}

// Of those measured, the one that was held comes first.
TEST_F(HeldPlate, IsToldFromThoseHeldElsewhere) {
  std::vector<MatrixXcd> screened;
  for (const Held& held : all_held()) {
    screened.push_back(frfs(through_the_free_one(held.nodes, held.components)));
  }
  const MatrixXcd plain = frfs(solved({}, "123"));
  for (const std::size_t true_one : {0U, 2U, 4U, 6U, 7U}) {
    const Held& held = all_held()[true_one];
    const MatrixXcd measured = frfs(solved(held.nodes, held.components));
    std::vector<double> errors;
    for (const MatrixXcd& H : screened) errors.push_back(error(H, measured));
    const auto first = std::ranges::min_element(errors) - errors.begin();
    EXPECT_EQ(static_cast<std::size_t>(first), true_one)
        << held.name << ": " << errors[true_one];
    EXPECT_LT(errors[true_one], 0.5 * error(plain, measured)) << held.name;
  }
}

TEST_F(HeldPlate, AnswersAsTheDeckThatHoldsIt) {
  // A clamp's modes are off by up to 3 %, half the width of a peak here; those
  // on a hinge, which turn freely, by a few thousandths.
  for (const auto& [which, most] :
       {std::pair{0U, 0.3}, std::pair{2U, 0.05}, std::pair{7U, 0.35}}) {
    const Held& held = all_held()[which];
    EXPECT_LT(error(frfs(through_the_free_one(held.nodes, held.components)),
                    frfs(solved(held.nodes, held.components))),
              most)
        << held.name;
  }
}

TEST_F(HeldPlate, ThatHoldsNothingIsTheFreeOne) {
  const acquisition::TestBundle bundle = support::plate_bundle();
  const structure::Deck deck = support::plate_deck(false);
  const BaseBuilder builder(
      deck, {}, support::plate_base(bundle, deck), Progress{});
  const ReducedBase base = builder.build({}, {});
  const BaseModes free = own_modes(base);
  const BaseModes same =
      modes_held(free, held_in(base, {}, ""), two_pi_of * 400.0);
  EXPECT_EQ(same.omega, free.omega);
}

}  // namespace
}  // namespace tapfit::updating
