// What is held in a base of a structure that is free, against closed forms and
// against decks that hold it.
#include "updating/reduction/held_motions.hpp"

#include "tests/updating/support/deck_support.hpp"
#include "tests/updating/support/sample_plate.hpp"
#include "tests/updating/support/twisting_frame.hpp"
#include "updating/reduction/reduced_base.hpp"

#include <Eigen/Eigenvalues>
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <optional>
#include <string>
#include <vector>

namespace tapfit::updating {
namespace {

using Eigen::MatrixXd;
using Eigen::VectorXd;

StiffnessChange holding(const std::vector<int>& nodes, const std::string& how) {
  StiffnessChange change;
  change.kind = ChangeKind::Support;
  change.of.effect = "support-mismatch";
  change.of.where.nodes = nodes;
  change.of.where.variant = how;
  return change;
}

VectorXd frequencies(const ReducedBase& base) {
  const VectorXd w2 =
      Eigen::SelfAdjointEigenSolver<MatrixXd>(base.K).eigenvalues();
  return w2.cwiseMax(0.0).cwiseSqrt() / (2.0 * std::numbers::pi);
}

// A steel beam of 1 m in 20 bars that bends in one plane and hangs free.
structure::Deck free_beam() {
  structure::Deck deck;
  deck.path = "beam.bdf";
  deck.coupled_mass = true;
  deck.materials[1] = {1, false, 210e9, 0.3, 210e9 / 2.6, 7800, 0, 0, 0};
  deck.bar_properties[1] = {1, 1, 4e-4, 3e-8, 1e-8, 0.0, 2e-8};
  for (int i = 0; i <= 20; ++i) {
    deck.grids.push_back({i + 1, {0.05 * i, 0.0, 0.0}});
    deck.constraints.push_back({i + 1, "1246"});
  }
  for (int i = 1; i <= 20; ++i) {
    deck.bars.push_back(structure::make_bar(i, 1, i, i + 1));
  }
  return deck;
}

class HeldBeam : public ::testing::Test {
 protected:
  HeldBeam() {
    BaseOptions options;
    options.high_hz = 400.0;
    options.split = false;
    options.points = {6 * 20 + 2, 6 * 8 + 2};
    builder_.emplace(deck_, Uncertain{}, options, Progress{});
  }

  using Uncertain = std::vector<acquisition::UncertainProperty>;

  // f = (lambda / L)^2 sqrt(E I / rho A) / 2 pi, lambda the roots of the
  // beam's characteristic equation (Blevins, "Formulas for Natural Frequency
  // and Mode Shape", 1979, table 8-1).
  void expect_roots(const StiffnessChange& change,
                    const std::vector<double>& roots) const {
    const VectorXd hz = frequencies(builder_->build({}, {change}));
    const double unit =
        std::sqrt(210e9 * 3e-8 / (7800 * 4e-4)) / (2.0 * std::numbers::pi);
    ASSERT_GE(hz.size(), static_cast<Eigen::Index>(roots.size()));
    for (std::size_t k = 0; k < roots.size(); ++k) {
      // Cubic elements of length h: (lambda h / L)^4 / 1440, below 2e-5.
      EXPECT_NEAR(
          hz(static_cast<Eigen::Index>(k)) / (roots[k] * roots[k] * unit),
          1.0,
          5e-5)
          << k;
    }
  }

  structure::Deck deck_ = free_beam();
  std::optional<BaseBuilder> builder_;
};

TEST_F(HeldBeam, AtOneEndIsACantilever) {
  EXPECT_TRUE(builder_->is_free());
  expect_roots(holding({1}, "held"), {1.87510407, 4.69409113, 7.85475744});
}

TEST_F(HeldBeam, AtBothEndsIsClampedTwice) {
  expect_roots(holding({1, 21}, "held"), {4.73004074, 7.85320462});
}

TEST_F(HeldBeam, OnTwoHingesIsPinned) {
  constexpr double pi = std::numbers::pi;
  expect_roots(holding({1, 21}, "held-translations"), {pi, 2.0 * pi});
}

// The hinge leaves one rigid motion.
TEST_F(HeldBeam, AlongOneAxisAtOneEndStillSwings) {
  const VectorXd hz =
      frequencies(builder_->build({}, {holding({1}, "held-Z")}));
  EXPECT_LT(hz(0), 1e-3 * hz(1));
  expect_roots(holding({1, 21}, "held-Z"), {std::numbers::pi});
}

// The first leg twists by the force alone that holds it.
TEST(HeldMotions, OfAFrameThatTwistsAreThoseOfADeckThatHoldsIt) {
  for (const auto& points :
       {std::vector<int>{44, 68}, std::vector<int>{20, 32, 44, 68}}) {
    const auto base_of =
        [&points](bool clamped, const std::vector<StiffnessChange>& changes) {
          BaseOptions options;
          options.high_hz = 700.0;
          options.points = points;
          const BaseBuilder builder(
              testing::twisting_frame(clamped), {}, options, Progress{});
          return frequencies(builder.build({}, changes, BaseUse::Scan));
        };
    const VectorXd clamped = base_of(true, {});
    const VectorXd found = base_of(false, {holding({1}, "held")});
    for (Eigen::Index k = 0; k < 5; ++k) {
      EXPECT_NEAR(found(k) / clamped(k), 1.0, 1e-5) << k;
    }
  }
}

// The deck of a plate that is clamped, and that of the same plate free and held
// along the same edge: every grid of the split mesh, too.
TEST(HeldMotions, OfAPlateAreThoseOfADeckThatHoldsIt) {
  const acquisition::TestBundle bundle = support::plate_bundle();
  for (const bool split : {false, true}) {
    const auto base_of = [&](bool clamped,
                             const std::vector<StiffnessChange>& changes) {
      const structure::Deck deck = support::plate_deck(clamped);
      BaseOptions options = support::plate_base(bundle, deck);
      options.split = split;
      const BaseBuilder builder(deck, {}, options, Progress{});
      return builder.build({}, changes, BaseUse::Scan);
    };
    const VectorXd clamped = frequencies(base_of(true, {}));
    const ReducedBase base =
        base_of(false, {holding({1, 12, 23, 34, 45}, "held")});
    EXPECT_TRUE(base.rows.row(6 * 11 + 2).isZero(0.0)) << "grid 12";
    EXPECT_GT(base.rows.row(6 * 10 + 2).norm(), 0.1) << "grid 11";
    const VectorXd found = frequencies(base);
    for (Eigen::Index k = 0; k < 5; ++k) {
      ASSERT_LT(clamped(k), 600.0);
      // Of the free plate's modes those to 1600 Hz are known.
      EXPECT_NEAR(found(k) / clamped(k), 1.0, 1e-5) << k;
      EXPECT_GE(found(k), (1.0 - 1e-8) * clamped(k)) << "Rayleigh";
    }
  }
}

// The same, elements at the edge softened besides: to half their stiffness.
TEST(HeldMotions, GoWithElementsThatSoften) {
  const acquisition::TestBundle bundle = support::plate_bundle();
  const auto softened = [&](bool clamped, std::vector<StiffnessChange> all) {
    const structure::Deck deck = support::plate_deck(clamped);
    BaseOptions options = support::plate_base(bundle, deck);
    options.split = false;
    StiffnessChange& loss = all.emplace_back();
    loss.of.effect = "stiffness-loss";
    for (const std::size_t k : {0U, 1U, 2U}) {
      loss.of.where.elements.push_back(deck.shells.at(k).id);
    }
    const BaseBuilder builder(deck, {}, options, Progress{});
    ReducedBase base = builder.build({}, all, BaseUse::Scan);
    EXPECT_EQ(base.terms.size(), 1U);
    base.K -= 0.5 * base.terms.front().S;
    return frequencies(base);
  };
  const VectorXd clamped = softened(true, {});
  const VectorXd found =
      softened(false, {holding({1, 12, 23, 34, 45}, "held")});
  for (Eigen::Index k = 0; k < 5; ++k) {
    EXPECT_NEAR(found(k) / clamped(k), 1.0, 1e-4) << k;
  }
}

TEST(HeldMotions, MoveNoneOfTheRows) {
  MatrixXd rows = MatrixXd::Random(4, 7);
  rows.row(3) = rows.row(0) - 2.0 * rows.row(1);
  rows.row(2).setZero();
  const MatrixXd Q = motions_without(rows);
  ASSERT_EQ(Q.cols(), 5);  // two rows tell something new
  EXPECT_LT((rows * Q).norm(), 1e-12);
  EXPECT_LT((Q.transpose() * Q - MatrixXd::Identity(5, 5)).norm(), 1e-12);
}

}  // namespace
}  // namespace tapfit::updating
