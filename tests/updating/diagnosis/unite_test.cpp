#include "tests/updating/support/hidden_in_plate.hpp"
#include "updating/catalogue/catalogue.hpp"
#include "updating/diagnosis/effect_forms.hpp"
#include "updating/diagnosis/forward_selection.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <string>
#include <vector>

namespace tapfit::updating {
namespace {

class Unite : public support::HiddenInPlate {
 protected:
  [[nodiscard]] Location clamp(const std::string& variant) const {
    Location where = effects::find("soft-support")
                         .places(support::plate_context(bundle_, deck_))
                         .front();
    where.variant = variant;
    return where;
  }

  // Each spring as soft as a fit would start from.
  [[nodiscard]] EffectInstance soft(const std::string& variant) const {
    const effects::Effect& effect = effects::find("soft-support");
    StiffnessChange change;
    change.kind = ChangeKind::Support;
    change.of = {effect.name(), clamp(variant)};
    EffectInstance result{&effect, clamp(variant), {}};
    for (const StiffnessTerm& term : builder_.build({}, {change}).terms) {
      result.p.push_back(term.start);
    }
    return result;
  }

  [[nodiscard]] Fit fitted(const std::vector<EffectInstance>& effects) const {
    return fitter_->fit(effects, fitter_->model_for(effects));
  }
};

TEST_F(Unite, TurningAndShiftingOfOneSupportAreOneEffect) {
  const EffectInstance both = soft("both");
  ASSERT_EQ(both.p.size(), 2U);
  hide({both});
  std::vector<SelectedEffect> chosen = {{"soft-support", 1.0},
                                        {"soft-support", 1.0}};
  const Fit fit =
      ForwardSelection(*fitter_, {})
          .unite(
              fitted({soft("rotation"), soft("translation")}), 0, chosen, {});
  ASSERT_EQ(fit.effects.size(), 1U);
  EXPECT_EQ(fit.effects[0].where.variant, "both");
  EXPECT_EQ(chosen.size(), 1U);
  // The same model made the FRFs; the fit stops within 1e-3 of its objective.
  EXPECT_NEAR(fit.effects[0].p[0] / both.p[0], 1.0, 2e-2);
  EXPECT_NEAR(fit.effects[0].p[1] / both.p[1], 1.0, 2e-2);
}

// Found one after the other, each with its own mass.
TEST_F(Unite, MassesOfTwoSensorsAreOneEffect) {
  const auto mass_of = [](const std::vector<std::string>& channels,
                          const std::string& variant,
                          const std::vector<double>& p) {
    Location where;
    where.channels = channels;
    where.variant = variant;
    return EffectInstance{&effects::find("sensor-mass"), where, p};
  };
  const std::vector<EffectInstance> found = {mass_of({"acc2"}, "", {0.01}),
                                             mass_of({"acc1"}, "", {0.01})};
  for (const double second : {0.02, 0.05}) {
    const bool alike = second == 0.02;
    hide({mass_of({"acc1", "acc2"}, "each", {0.02, second})});
    std::vector<SelectedEffect> chosen = {{"sensor-mass", 1.0},
                                          {"sensor-mass", 1.0}};
    const Fit fit =
        ForwardSelection(*fitter_, {}).unite(fitted(found), 0, chosen, {});
    ASSERT_EQ(fit.effects.size(), 1U);
    EXPECT_EQ(chosen.size(), 1U);
    EXPECT_EQ(fit.effects[0].where.channels.size(), 2U);
    EXPECT_EQ(fit.effects[0].where.variant, alike ? "" : "each");
    // The same model made the FRFs; the fit stops within 1e-3 of its objective.
    EXPECT_NEAR(fit.effects[0].p.front(), 0.02, 4e-4);
    EXPECT_NEAR(fit.effects[0].p.back(), second, 0.02 * second);
  }
}

TEST_F(Unite, OtherEffectsStayApart) {
  Location grid;
  grid.node = 31;
  const EffectInstance mass{&effects::find("added-mass"), grid, {0.02}};
  hide({soft("rotation"), mass});
  std::vector<SelectedEffect> chosen = {{"soft-support", 1.0},
                                        {"added-mass", 1.0}};
  const Fit fit = ForwardSelection(*fitter_, {})
                      .unite(fitted({soft("rotation"), mass}), 0, chosen, {});
  ASSERT_EQ(fit.effects.size(), 2U);
  EXPECT_EQ(fit.effects[0].where.variant, "rotation");
  EXPECT_EQ(chosen.size(), 2U);
}

// A clamp that only turns, and one that moves as well.
TEST_F(Unite, FormIsThePlainOneWhereThatIsAsLikely) {
  Location grid;
  grid.node = 30;
  const EffectInstance mass{&effects::find("added-mass"), grid, {0.05}};
  hide({soft("rotation"), mass});
  const Fit beside = fitted({soft("both"), mass});
  ASSERT_EQ(beside.effects[0].where.variant, "both");
  const auto plain = in_plain_form(beside, 0, *fitter_, {});
  ASSERT_TRUE(plain);
  EXPECT_EQ(plain->effects[0].where.variant, "rotation");
  // The same model made the FRFs; the fit stops within 1e-3 of its objective.
  EXPECT_NEAR(plain->effects[0].p[0] / soft("rotation").p[0], 1.0, 1e-2);
  EXPECT_FALSE(in_plain_form(beside, 1, *fitter_, {}));  // has no form
  hide({soft("both"), mass});
  EXPECT_FALSE(in_plain_form(fitted({soft("both"), mass}), 0, *fitter_, {}));
}

// A quick look takes one motion of the clamp; its forms are added, and better.
TEST_F(Unite, QuickLookIsGivenTheFormsOfWhatComesNear) {
  hide({soft("both")});
  const Fit base = fitted({});
  const ForwardSelection search(*fitter_, {});
  const CandidateRanking quick =
      search.look(base, ForwardSelection::Depth::Quick, {});
  const auto has_both = [](const CandidateRanking& round) {
    return std::ranges::any_of(round.hypotheses, [](const Hypothesis& h) {
      return h.own().where.variant == "both";
    });
  };
  EXPECT_FALSE(has_both(quick));
  const CandidateRanking formed = search.with_forms(quick, base, {});
  ASSERT_TRUE(has_both(formed));
  EXPECT_EQ(formed.hypotheses.front().own().where.variant, "both");
  EXPECT_EQ(formed.probability.size(), formed.hypotheses.size() + 1);
}

}  // namespace
}  // namespace tapfit::updating
