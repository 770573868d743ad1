// A mesh of lumped masses, on a clamp that gives, against the same split twice.
#include "updating/frf_model/mesh_at_state.hpp"

#include "tests/updating/support/sample_plate.hpp"
#include "updating/catalogue/catalogue.hpp"
#include "updating/structure/mesh/refine_mesh.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <complex>

namespace tapfit::updating {
namespace {

using Eigen::Index;
using Eigen::VectorXd;

constexpr Index modes = 5;  // in the band of 400 Hz

structure::Deck lumped() {
  structure::Deck deck = support::plate_deck(true);
  deck.coupled_mass = false;
  return deck;
}

// As stiff as the plate is over its length.
EffectInstance clamp_that_gives(const structure::Deck& deck) {
  EffectInstance soft{&effects::find("soft-support"), {}, {600.0}};
  soft.where.variant = "rotation";
  for (const structure::Grid& grid : deck.grids) {
    if (grid.position.x() == 0.0) soft.where.nodes.push_back(grid.id);
  }
  return soft;
}

class MeshAtState : public ::testing::Test {
 protected:
  FrfModel model(const structure::Deck& deck,
                 const BaseBuilder& builder,
                 const EffectInstance& soft) const {
    const StiffnessChange change{
        ChangeKind::Support, {"soft-support", soft.where}, 3};
    return {builder.build({}, {change}),
            support::plate_context(bundle_, deck),
            support::plate_pairs(bundle_, VectorXd::Ones(1))};
  }

  BaseBuilder builder(const structure::Deck& deck, bool split) const {
    BaseOptions options = support::plate_base(bundle_, deck);
    options.split = split;
    return {deck, {}, options, Progress{}};
  }

  acquisition::TestBundle bundle_ = support::plate_bundle();
};

TEST_F(MeshAtState, ForetellsTheMeshSplitTwice) {
  const structure::Deck deck = lumped();
  const structure::Deck split = structure::refine_mesh(deck).deck;
  const BaseBuilder coarse = builder(deck, false);
  BaseBuilder fine = builder(deck, true);
  const std::size_t factors = fine.hold_corrections(coarse).size();
  const BaseBuilder finest = builder(split, true);

  ModelState state;
  state.factor.assign(factors, 1.0);
  state.effects = {clamp_that_gives(deck)};
  ModelState on_split;
  on_split.effects = {clamp_that_gives(split)};
  const FrfModel on_fine = model(deck, fine, state.effects[0]);
  const FrfModel on_coarse = model(deck, coarse, state.effects[0]);
  const auto frequencies = [](const FrfModel& of, const ModelState& at) {
    return VectorXd(of.base_modes(at).omega.head(modes));
  };
  const VectorXd truth =
      frequencies(model(split, finest, on_split.effects[0]), on_split);
  const VectorXd before = frequencies(on_coarse, state);
  const VectorXd after = frequencies(on_fine, state);

  // Where the error falls with the square of the element, splitting again
  // changes a quarter of what splitting changed.
  state.factor[0] = 1.25;
  const auto shifted = with_mesh_at(on_fine, on_coarse, state, 0);
  const VectorXd told = frequencies(*shifted, state);
  for (Index r = 0; r < modes; ++r) {
    // The law is one of ever smaller elements.
    EXPECT_NEAR(told(r), truth(r), 0.05 * std::abs(after(r) - before(r))) << r;
  }
  // The clamped plate's own shift is another one.
  const auto worst = [&truth](const VectorXd& omega) {
    return (omega - truth).cwiseQuotient(truth).cwiseAbs().maxCoeff();
  };
  EXPECT_LT(worst(told), 0.5 * worst(frequencies(on_fine, state)));
  // Who asks for other points takes the base, and the shift with it.
  const FrfModel elsewhere(shifted->base(),
                           support::plate_context(bundle_, deck),
                           support::plate_pairs(bundle_, VectorXd::Ones(1)));
  EXPECT_EQ(frequencies(elsewhere, state), told);
}

// The form's patterns say it of each mode, in the order 11, 12 ... 16, 22 ...:
// the share of what the mesh's factor does to its stiffness, by differences.
TEST_F(MeshAtState, LeavesAShareOfWhatItChangedOfEachMode) {
  const structure::Deck deck = lumped();
  const BaseBuilder coarse = builder(deck, false);
  BaseBuilder fine = builder(deck, true);
  const std::size_t factors = fine.hold_corrections(coarse).size();
  ModelState state;
  state.factor.assign(factors, 1.0);
  state.effects = {clamp_that_gives(deck)};
  const FrfModel on_fine = model(deck, fine, state.effects[0]);
  const Eigen::VectorXcd s = Eigen::VectorXcd::Constant(
      1, std::complex<double>(0.0, on_fine.base_modes(state).omega(0)));
  const VectorXd left = on_fine.form_patterns(state, s).mesh_sd;
  const auto stiffness = [&](double factor) {
    state.factor[0] = factor;
    return VectorXd(on_fine.base_modes(state).omega.head(2).cwiseAbs2());
  };
  constexpr double h = 1e-4;
  const VectorXd change =
      (stiffness(1.0 + h) - stiffness(1.0 - h)).cwiseQuotient(stiffness(1.0)) /
      (2.0 * h);
  ASSERT_GE(left.size(), 7);
  EXPECT_GT(std::abs(change(0)), 1e-3);
  EXPECT_NEAR(left(0), 0.19 * std::abs(change(0)), 1e-6);
  EXPECT_NEAR(left(6), 0.19 * std::abs(change(1)), 1e-6);
  // What all modes have in common is fitted.
  EXPECT_TRUE(left.tail(3).isZero(0.0));
}

}  // namespace
}  // namespace tapfit::updating
