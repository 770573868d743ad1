#include "updating/frf_model/frf_model.hpp"

#include "tests/updating/support/direct_frfs.hpp"
#include "tests/updating/support/plate_model.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <utility>

namespace tapfit::updating {
namespace {

using Eigen::Index;
using Eigen::MatrixXcd;

using FrfModelTest = PlateModel;

TEST_F(FrfModelTest, BaseAgreesWithDirectSolve) {
  const auto model = fitter_->model_for({}, BaseUse::Scan);
  const MatrixXcd H =
      model->respond(undamped_state(*fitter_, *model, {}), s_, false).H;
  // What the basis is made for, see response_orders.
  EXPECT_LT(difference(H, direct_frfs(deck_, pairs_, {}, s_)), 1e-6);
}

TEST_F(FrfModelTest, LowRankEffectsAgreeWithDirectSolve) {
  const std::vector<EffectInstance> effects = {
      at_node("added-mass", 30, 0.05),
      at_node("ground-spring", 50, 3e4),
      at_node("dashpot", 20, 7.0),
      sensors(0.01, 0.02)};
  const auto model = fitter_->model_for(effects, BaseUse::Scan);
  const MatrixXcd H =
      model->respond(undamped_state(*fitter_, *model, effects), s_, false).H;
  const MatrixXcd exact = direct_frfs(
      deck_,
      pairs_,
      {{30, 2, 0.05}, {50, 0, 3e4}, {20, 1, 7.0}, {11, 2, 0.01}, {36, 2, 0.02}},
      s_);
  EXPECT_LT(difference(H, exact), 1e-6);
}

// A spring between grids is a spring at a grid where the place is the grid's;
// what moves elsewhere is tested in between_grids_test.
TEST_F(FrfModelTest, SpringBetweenGridsAgreesWithAGridThere) {
  EffectInstance spring = at_node("ground-spring", 50, 3e4);
  const auto at_grid = fitter_->model_for({spring}, BaseUse::Scan);
  const MatrixXcd H =
      at_grid->respond(undamped_state(*fitter_, *at_grid, {spring}), s_, false)
          .H;
  const Eigen::Vector3d x = position_of(spring.where, deck_);
  spring.where.at = {x.x(), x.y(), x.z()};
  const auto between = fitter_->model_for({spring}, BaseUse::Scan);
  const MatrixXcd same =
      between->respond(undamped_state(*fitter_, *between, {spring}), s_, false)
          .H;
  // Rows of the base's own columns are of single precision.
  EXPECT_LT(difference(H, same), 1e-7);
}

TEST_F(FrfModelTest, SwappedChannelsRecordEachOther) {
  Location both;
  both.channels = {"acc1", "acc2"};
  const auto model = fitter_->model_for({});
  ModelState state = undamped_state(*fitter_, *model, {});
  const MatrixXcd H = model->respond(state, s_, false).H;
  state.effects = {{&effects::find("channel-swap"), both, {}}};
  const MatrixXcd swapped = model->respond(state, s_, false).H;
  // The bundle has acc1 and acc2 in turn, run after run.
  for (Eigen::Index f = 0; f < H.cols(); f += 2) {
    EXPECT_EQ(swapped.col(f), H.col(f + 1));
    EXPECT_EQ(swapped.col(f + 1), H.col(f));
  }
}

TEST_F(FrfModelTest, DerivativesAgreeWithDifferences) {
  const std::vector<EffectInstance> effects = {
      at_node("added-mass", 30, 0.05),
      at_node("ground-spring", 50, 3e4),
      at_node("dashpot", 20, 7.0),
      sensors(0.01, 0.02)};
  const auto model = fitter_->model_for(effects);
  ModelState state = fitter_->first_state(*model, effects);
  state.factor = {1.02};
  state.zeta.setLinSpaced(0.004, 0.02);
  // Central differences of step 1e-5 are good to about 1e-8 here.
  EXPECT_LT(derivative_error(*model, state, s_), 1e-6);
}

// The first modes and those beside them, with springs and a faulty channel in
// the model: central differences in the base's own stiffness.
TEST_F(FrfModelTest, FormPatternsAgreeWithDifferences) {
  Location channel;
  channel.channels = {"acc1"};
  const std::vector<EffectInstance> effects = {
      at_node("dashpot", 50, 3.0),
      {&effects::find("channel-gain"), channel, {1.3}}};
  const auto model = fitter_->model_for(effects);
  const ModelState state = undamped_state(*fitter_, *model, effects);
  const std::vector<MatrixXcd> patterns = model->form_patterns(state, s_).dH;
  const BaseModes modes = model->base_modes(state);
  // Entries in order: 11, 12, 13, 22, ...
  const std::vector<std::pair<Index, Index>> entries = {{0, 0}, {0, 1}, {0, 2}};
  for (std::size_t k = 0; k < entries.size(); ++k) {
    const auto [i, j] = entries[k];
    const Eigen::VectorXd a = modes.omega(i) * modes.phi.col(i);
    const Eigen::VectorXd b = modes.omega(j) * modes.phi.col(j);
    const Eigen::MatrixXd one =
        i == j ? Eigen::MatrixXd(a * a.transpose())
               : Eigen::MatrixXd((a * b.transpose() + b * a.transpose()) /
                                 std::sqrt(2.0));
    // Smaller ones beside the diagonal count as rounding, see solve_modes().
    const double h = 1e-3;
    const auto changed = [&](double by) {
      ReducedBase base = model->base();
      base.K += by * one;
      return FrfModel(base, context_, pairs_).respond(state, s_, false).H;
    };
    const MatrixXcd numeric = (changed(h) - changed(-h)) / (2.0 * h);
    // Central differences are off by h^2 over the square of the damping.
    EXPECT_LT(difference(patterns[k], numeric), 1e-3) << i << ' ' << j;
  }
}

// A law's damping turns with the modes as matrices do: no part is left out.
TEST_F(FrfModelTest, DerivativesOfADampingLawAgreeWithDifferences) {
  const std::vector<EffectInstance> effects = {
      at_node("added-mass", 30, 0.05),
      {&effects::find("damping-law"), {}, {4.0, 2e-6, 0.01}}};
  const auto model = fitter_->model_for(effects);
  ModelState state = fitter_->first_state(*model, effects);
  EXPECT_EQ(state.zeta.size(), 0);
  state.factor = {1.02};
  EXPECT_LT(derivative_error(*model, state, s_), 1e-6);
}

// The highest mode too, for which other fits have one ratio in common.
TEST_F(FrfModelTest, ALawGivesTheModesItsRatios) {
  const EffectInstance law{
      &effects::find("damping-law"), {}, {4.0, 2e-6, 0.01}};
  const auto model = fitter_->model_for({law});
  const ModelState state = fitter_->first_state(*model, {law});
  ModelState mode_by_mode = state;
  mode_by_mode.effects.clear();
  const Eigen::VectorXd omega = model->base_modes(state).omega;
  mode_by_mode.zeta =
      omega.unaryExpr([&](double each) { return state.zeta_at(each); });
  const MatrixXcd expected = model->respond(mode_by_mode, s_, false).H;
  EXPECT_LT(difference(model->respond(state, s_, false).H, expected), 1e-12);
}

}  // namespace
}  // namespace tapfit::updating
