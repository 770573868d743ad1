#include "updating/search/hypotheses.hpp"

#include "acquisition/foundation/parallel.hpp"
#include "tests/updating/support/hidden_in_plate.hpp"
#include "updating/catalogue/catalogue.hpp"
#include "updating/diagnosis/error_ladder.hpp"
#include "updating/diagnosis/patch_extent.hpp"
#include "updating/fit/estimates.hpp"
#include "updating/places/near_places.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>

namespace tapfit::updating {
namespace {

using Eigen::Index;

/// The kinds worth a full fit of what is hidden in the plate.
class Hidden : public support::HiddenInPlate {
 protected:
  [[nodiscard]] std::vector<Hypothesis> tried(int neighbours) const {
    HypothesisOptions options;
    options.places_per_kind = 1;
    options.neighbours = neighbours;
    const Fit base = fitter_->fit({}, fitter_->model_for({}));
    std::vector<Hypothesis> all = fit_hypotheses(base, *fitter_, options, {});
    std::sort(all.begin(), all.end(), [](const auto& a, const auto& b) {
      return a.fit.result.error < b.fit.result.error;
    });
    return all;
  }

  void expect_found(const std::vector<int>& elements, double factor) {
    Location where;
    where.elements = elements;
    hide({{&effects::find("stiffness-loss"), where, {factor}}});
    const Hypothesis best = tried(8).front();
    EXPECT_EQ(best.own().effect->name(), "stiffness-loss");
    EXPECT_EQ(best.own().where.elements, elements);
    // The same model made the FRFs; the fit stops within 1e-3 of its objective.
    EXPECT_NEAR(best.own().p[0], factor, 1e-3);
  }
};

// Who looks on is told of fits that are nearly there, then of those that have
// ended, the likeliest first.
TEST_F(Hidden, IsToldAsItIsTried) {
  Location where;
  where.node = 25;
  hide({{&effects::find("added-mass"), where, {0.05}}});
  HypothesisOptions options;
  options.neighbours = 0;
  std::vector<std::string> told;
  options.tried = [&told](const Fit& fit) {
    told.push_back(fit.effects.back().effect->name());
  };
  const Fit base = fitter_->fit({}, fitter_->model_for({}));
  // A piece of parallel work is done on one thread: on several, the order in
  // which fits end is not that in which they begin.
  std::size_t all = 0;
  for_each_parallel(2, [&](std::size_t piece) {
    if (piece == 0) all = fit_hypotheses(base, *fitter_, options, {}).size();
  });
  ASSERT_GT(all, 2U);
  ASSERT_GE(told.size(), 2 * all);
  EXPECT_EQ(told[told.size() - all], "added-mass");
}

TEST_F(Hidden, LossFarFromSmallIsFoundAtItsOwnPatch) {
  // Three by three elements with a fifth of their stiffness left: the first
  // order of the screening does not hold there.
  expect_found({2, 3, 4, 12, 13, 14, 22, 23, 24}, 0.2);
}

TEST_F(Hidden, LossOfALongStripIsFoundAsItIs) {
  // Six elements in line, which no cube holds alone.
  expect_found({13, 14, 15, 16, 17, 18}, 0.4);
}

// Where the model may be wrong by as much as other patches leave, their factors
// belong to the interval; where it is known better, they do not.
TEST_F(Hidden, PatchesThatLeaveNoMoreThanTheFloorWidenTheInterval) {
  Location where;
  where.elements = {12, 13, 22, 23};
  hide({{&effects::find("stiffness-loss"), where, {0.5}}});
  const std::vector<Hypothesis> all = tried(8);
  const EffectInstance& own = all.front().own();
  ASSERT_EQ(own.where.elements, where.elements);
  const effects::TestContext& context = fitter_->problem().context;
  EXPECT_FALSE(patch_extent(all, own, 0.0, context));
  const Hypothesis* next = nullptr;  // of those that overlap
  for (const Hypothesis& h : all) {
    const bool overlaps = h.own().effect == own.effect &&
                          h.own().where != own.where &&
                          share(h.own().where.elements, where.elements);
    if (overlaps && next == nullptr) next = &h;
  }
  ASSERT_NE(next, nullptr);
  const auto extent = patch_extent(all, own, next->fit.result.error, context);
  ASSERT_TRUE(extent);
  const std::size_t size = next->own().where.elements.size();
  EXPECT_EQ(extent->fewest, std::min<std::size_t>(4, size));
  EXPECT_EQ(extent->most, std::max<std::size_t>(4, size));
  Estimate factor = effect_estimates(all.front().fit, 0, context).front();
  const Estimate before = factor;
  widen(*extent, factor);
  EXPECT_LE(factor.lo95, std::min(before.lo95, next->own().p[0]));
  EXPECT_GE(factor.hi95, std::max(before.hi95, next->own().p[0]));
  EXPECT_EQ(factor.value, before.value);
  EXPECT_GT(factor.sd, before.sd);
  EXPECT_LE(factor.sd, (factor.hi95 - factor.lo95) / 3.92 + 1e-12);
  // And so it stands in the ladder.
  SelectedEffect chosen{"stiffness-loss", 1.0};
  chosen.extent = extent;
  const Rung rung =
      ladder_of(all.front().fit, {chosen}, 0, *fitter_, {}).front();
  EXPECT_EQ(rung.parameters.front().lo95, factor.lo95);
  EXPECT_EQ(rung.parameters.front().hi95, factor.hi95);
  // Other kinds have no patches.
  for (const Hypothesis& h : all) {
    if (h.own().effect->name() != "added-mass") continue;
    EXPECT_FALSE(patch_extent(all, h.own(), 1.0, context));
  }
}

TEST_F(Hidden, MassIsFoundAtItsOwnGrid) {
  Location where;
  where.node = 31;
  hide({{&effects::find("added-mass"), where, {0.02}}});
  const std::vector<Hypothesis> all = tried(8);
  const auto mass =
      std::find_if(all.begin(), all.end(), [](const Hypothesis& h) {
        return h.own().effect->name() == "added-mass";
      });
  ASSERT_NE(mass, all.end());
  EXPECT_EQ(mass->own().where.node, 31);
  EXPECT_NEAR(mass->own().p[0], 0.02, 2e-5);
}

// What is known already stands among the others as it is, and what leaves many
// times its error is not looked at any closer.
TEST_F(Hidden, KnownEffectIsNotFittedAgainAndRuledOutKindsAreNotFollowed) {
  Location where;
  where.node = 31;
  const EffectInstance mass{&effects::find("added-mass"), where, {0.02}};
  hide({mass});
  const Fit known = fitter_->fit({mass}, fitter_->model_for({mass}));
  HypothesisOptions options;
  options.places_per_kind = 1;
  const Fit base = fitter_->fit({}, fitter_->model_for({}));
  const auto count = [](const std::vector<Hypothesis>& all,
                        const std::string& kind) {
    return std::ranges::count_if(all, [&kind](const Hypothesis& h) {
      return h.own().effect->name() == kind;
    });
  };
  const std::vector<Hypothesis> without =
      fit_hypotheses(base, *fitter_, options, {});
  options.known = &known;
  const std::vector<Hypothesis> with =
      fit_hypotheses(base, *fitter_, options, {});
  const auto same = std::ranges::find_if(with, [&mass](const Hypothesis& h) {
    return h.own().effect == mass.effect && h.own().where == mass.where;
  });
  ASSERT_NE(same, with.end());
  EXPECT_EQ(same->fit.result.error, known.result.error);
  EXPECT_EQ(same->fit.result.history.size(), known.result.history.size());
  // The mass leaves next to nothing: no spring comes near it, and of springs
  // only what the screening put first is tried.
  EXPECT_LE(count(with, "ground-spring"), 2);
  EXPECT_GE(count(without, "added-mass"), count(with, "added-mass"));
}

// A wire pulls at the tip: it is told from springs, loss and masses, and its
// force and side stiffness are found.
TEST_F(Hidden, PullOfAWireIsFound) {
  const effects::Effect& effect = effects::find("prestress");
  const Location where =
      effect.places(support::plate_context(bundle_, deck_)).front();
  StiffnessChange change;
  change.kind = ChangeKind::Preload;
  change.of = {effect.name(), where};
  const ReducedBase base = builder_.build({}, {change});
  const std::vector<double> p = {3.0 * base.terms[0].start,
                                 0.5 * base.terms[1].start};
  hide({{&effect, where, p}});
  const Hypothesis best = tried(0).front();
  ASSERT_EQ(best.own().effect->name(), "prestress");
  EXPECT_EQ(best.own().where, where);
  // The same model made the FRFs; the fit stops within 1e-3 of its objective.
  EXPECT_NEAR(best.own().p[0] / p[0], 1.0, 1e-2);
  EXPECT_NEAR(best.own().p[1] / p[1], 1.0, 5e-2);
}

}  // namespace
}  // namespace tapfit::updating
