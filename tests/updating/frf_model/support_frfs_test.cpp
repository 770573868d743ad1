// FRFs of a plate whose supports and joints give way.
#include "tests/updating/support/direct_frfs.hpp"
#include "tests/updating/support/plate_model.hpp"
#include "updating/frf_model/frf_model.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <string>

namespace tapfit::updating {
namespace {

using Eigen::MatrixXcd;

using FrfModelTest = PlateModel;

TEST_F(FrfModelTest, SoftSupportAgreesWithDirectSolveFromStiffToSoft) {
  const auto model = fitter_->model_for({clamp(1.0)}, BaseUse::Scan);
  const StiffnessTerm& term = model->base().terms.front();
  std::vector<int> rotations;
  for (int j = 0; j < 5; ++j) rotations.push_back(6 * 11 * j + 4);
  for (const double k : {term.lower, 3.0 * term.start, 0.1 * term.upper}) {
    const ModelState state = undamped_state(*fitter_, *model, {clamp(k)});
    const MatrixXcd H = model->respond(state, s_, false).H;
    const MatrixXcd exact = direct_frfs(deck_, pairs_, {}, s_, rotations, k);
    // What the basis is made for, see basis_enrichment.hpp.
    EXPECT_LT(difference(H, exact), 1e-6) << "k = " << k;
  }
}

// The plate cut along x = 0.15 m, its halves held together by springs: stiff
// ones, but for the rotation about the cut.
structure::Deck jointed_plate(const structure::Deck& plate, double k_per_m) {
  structure::Deck deck = plate;
  std::map<int, int> twin;
  int spring = 1000;
  for (int j = 0; j < 5; ++j) {
    const int id = 6 + 11 * j;
    twin[id] = 100 + id;
    deck.grids.push_back({100 + id, deck.grids[deck.grid_index(id)].position});
    const double length = j == 0 || j == 4 ? 0.015 : 0.03;
    for (int c = 1; c <= 6; ++c) {
      structure::ScalarElement e;
      e.id = spring++;
      e.grids = {id, 100 + id};
      e.components = {c, c};
      e.stiffness = c == 5 ? k_per_m * length : c > 3 ? 1e7 : 1e11;
      deck.scalars.push_back(e);
    }
  }
  for (structure::Shell& shell : deck.shells) {
    const bool right = (shell.id - 1) % 10 >= 5;
    for (int& grid : shell.grids) {
      if (right && twin.contains(grid)) grid = twin[grid];
    }
  }
  return deck;
}

TEST_F(FrfModelTest, JointAgreesWithDirectSolveFromStiffToSoft) {
  const effects::Effect& effect = effects::find("joint");
  Location where;
  for (const Location& place : effect.places(context_)) {
    const auto& n = place.nodes;
    if (n.size() == 5 && std::find(n.begin(), n.end(), 6) != n.end()) {
      where = place;
    }
  }
  ASSERT_EQ(where.nodes.size(), 5U);
  const auto model = fitter_->model_for({{&effect, where, {1.0}}});
  const StiffnessTerm& term = model->base().terms.front();
  for (const double k : {term.lower, term.start, 0.1 * term.upper}) {
    const ModelState state =
        undamped_state(*fitter_, *model, {{&effect, where, {k}}});
    const MatrixXcd H = model->respond(state, s_, false).H;
    const MatrixXcd exact =
        direct_frfs(jointed_plate(deck_, k), pairs_, {}, s_);
    EXPECT_LT(difference(H, exact), 1e-4) << "k = " << k;
  }
}

// The plate on which nothing is held, or only the rotations are let go.
TEST_F(FrfModelTest, SupportThatWasNotThereHoldsNothing) {
  const effects::Effect& effect = effects::find("support-mismatch");
  for (const std::string variant : {"free", "free-rotations"}) {
    const std::vector<Location> places = effect.places(context_);
    const auto where = std::ranges::find(places, variant, &Location::variant);
    ASSERT_NE(where, places.end()) << variant;
    const EffectInstance freed{&effect, *where, {}};
    const auto model = fitter_->model_for({freed});
    const ModelState state = undamped_state(*fitter_, *model, {freed});
    structure::Deck deck = support::plate_deck(false);
    for (int j = 0; variant != "free" && j < 5; ++j) {
      deck.constraints.push_back({1 + 11 * j, "123"});
    }
    // Rotations are lent a mass, which is felt at 1e-5.
    EXPECT_LT(difference(model->respond(state, s_, false).H,
                         direct_frfs(deck, pairs_, {}, s_)),
              1e-4)
        << variant;
  }
}

TEST_F(FrfModelTest, DerivativesAgreeWithDifferencesOnASoftSupport) {
  auto effects = std::vector<EffectInstance>{clamp(1.0)};
  const auto model = fitter_->model_for(effects);
  effects.back().p[0] = model->base().terms.front().start;
  const ModelState state = fitter_->first_state(*model, effects);
  // FRFs change little with a support this stiff, and differences of them lose
  // digits: 2e-5 at a tenth of the step.
  EXPECT_LT(derivative_error(*model, state, s_), 1e-5);
}

TEST_F(FrfModelTest, DerivativesAgreeWithDifferencesOnFormsOfASupport) {
  for (const char* form : {"both", "rotation-varying", "translation-varying"}) {
    auto effects = std::vector<EffectInstance>{clamp(1.0)};
    effects.back().where.variant = form;
    effects.back().p = {1.0, 1.0};
    const auto model = fitter_->model_for(effects);
    const std::vector<StiffnessTerm>& terms = model->base().terms;
    ASSERT_EQ(terms.size(), 2U) << form;
    effects.back().p = {terms[0].start, 0.3 * terms[1].start};
    const ModelState state = fitter_->first_state(*model, effects);
    // Rounding: it grows as the step shrinks, 1e-4 at a tenth of it and 6e-7
    // at ten times, where other parameters' differences are 4e-5 off.
    EXPECT_LT(derivative_error(*model, state, s_), 3e-5) << form;
  }
}

// The same springs told in two ways.
TEST_F(FrfModelTest, AClampThatVariesByNothingIsTheEvenOne) {
  const auto even = fitter_->model_for({clamp(1.0)});
  const double k = even->base().terms.front().start;
  const MatrixXcd H =
      even->respond(undamped_state(*fitter_, *even, {clamp(k)}), s_, false).H;
  EffectInstance varying = clamp(k);
  varying.where.variant = "rotation-varying";
  varying.p = {k, k};
  const auto model = fitter_->model_for({varying});
  const ModelState state = undamped_state(*fitter_, *model, {varying});
  // Each has a span of its own, which leaves out 1e-4 of amplitudes.
  EXPECT_LT(difference(model->respond(state, s_, false).H, H), 1e-6);
  // A rigid translation beside the turn leaves the turn alone.
  EffectInstance both = clamp(k);
  both.where.variant = "both";
  both.p = {k, 1.0};
  const auto of_both = fitter_->model_for({both});
  both.p[1] = 1e3 * of_both->base().terms[1].upper;
  const ModelState stiff = undamped_state(*fitter_, *of_both, {both});
  EXPECT_LT(difference(of_both->respond(stiff, s_, false).H, H), 1e-5);
}

}  // namespace
}  // namespace tapfit::updating
