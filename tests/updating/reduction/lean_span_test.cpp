#include "updating/reduction/lean_span.hpp"

#include "tests/updating/support/sample_plate.hpp"
#include "updating/catalogue/catalogue.hpp"
#include "updating/frf_model/acted_points.hpp"
#include "updating/frf_model/frf_model.hpp"
#include "updating/measurement/damped_line.hpp"

#include <gtest/gtest.h>

#include <tuple>
#include <vector>

namespace tapfit::updating {
namespace {

// A plate whose wood and thickness are uncertain.
class LeanSpan : public ::testing::Test {
 protected:
  LeanSpan() {
    deck_.materials[1] = {
        1, true, 12e9, 0.35, 0.7e9, 450.0, 0.9e9, 0.7e9, 0.1e9};
    bundle_.uncertain = {{"material", 1, "E1", 20.0},
                         {"material", 1, "E2", 20.0},
                         {"material", 1, "G12", 20.0},
                         {"property", 1, "t", 5.0}};
  }

  [[nodiscard]] BaseBuilder builder() const {
    return {deck_,
            bundle_.uncertain,
            support::plate_base(bundle_, deck_),
            Progress{}};
  }
  [[nodiscard]] FrfModel model(const ReducedBase& base) const {
    return {base, context_, support::plate_pairs(bundle_, s_)};
  }
  [[nodiscard]] Eigen::MatrixXcd respond(const FrfModel& model,
                                         const ModelState& state) const {
    return model.respond(state, s_, false).H;
  }

  structure::Deck deck_ = support::plate_deck(true);
  acquisition::TestBundle bundle_ = support::plate_bundle();
  effects::TestContext context_ = support::plate_context(bundle_, deck_);
  Eigen::VectorXcd s_ = damped_line({10.0, 400.0}, 2.0, {0.03, 80});
};

// The whole base is exact to 1e-6 as the deck is; where properties differ it
// is what the lean one is compared with.
TEST_F(LeanSpan, AnswersAsTheWholeBaseOverTheRangeOfProperties) {
  const BaseBuilder bases = builder();
  const FrfModel wide = model(bases.build({}, {}, BaseUse::Scan));
  const FrfModel narrow = model(bases.build({}, {}, BaseUse::Fit));
  const std::vector<std::vector<double>> states = {
      {1.0, 1.0, 1.0, 1.0}, {1.3, 0.8, 1.2, 0.95}, {0.7, 1.4, 0.7, 1.1}};
  for (const std::vector<double>& factor : states) {
    ModelState state;
    state.factor = factor;
    const Eigen::MatrixXcd whole = respond(wide, state);
    const Eigen::MatrixXcd lean = respond(narrow, state);
    // A hundredth of the scatter of a careful test.
    EXPECT_LT((lean - whole).norm(), 1e-4 * whole.norm()) << factor[0];
  }
}

// What gives way, from next to nothing to all of it, at changed properties,
// too.
TEST_F(LeanSpan, AnswersAsTheWholeBaseWhereStiffnessIsLost) {
  const BaseBuilder bases = builder();
  Location patch;
  patch.elements = {12, 13, 14, 22, 23, 24};
  Location line;
  line.nodes = {5, 16, 27, 38, 49};
  Location clamp;
  clamp.nodes = {1, 12, 23, 34, 45};
  clamp.variant = "rotation";
  for (const auto& [name, kind, where] :
       {std::tuple{"stiffness-loss", ChangeKind::Elements, patch},
        std::tuple{"joint", ChangeKind::Joint, line},
        std::tuple{"soft-support", ChangeKind::Support, clamp}}) {
    const StiffnessChange change{kind, {name, where}, context_.component};
    const FrfModel wide = model(bases.build({}, {change}, BaseUse::Scan));
    const FrfModel narrow = model(bases.build({}, {change}, BaseUse::Fit));
    const StiffnessTerm& term = narrow.base().terms.front();
    for (const double p : {term.lower, term.start, 0.9 * term.upper}) {
      ModelState state;
      state.factor = {1.2, 0.8, 1.1, 0.95};
      state.effects = {{&effects::find(name), where, {p}}};
      const Eigen::MatrixXcd whole = respond(wide, state);
      const Eigen::MatrixXcd lean = respond(narrow, state);
      // What loss_modes() is good to.
      EXPECT_LT((lean - whole).norm(), 5e-4 * whole.norm()) << name << ' ' << p;
    }
  }
}

// Its size is what every evaluation of a fit costs, cubed.
TEST_F(LeanSpan, IsSmallerThanTheBase) {
  bundle_.uncertain = {{"property", 1, "t", 5.0}};
  const BaseBuilder bases = builder();
  EXPECT_LT(bases.build({}, {}, BaseUse::Fit).size(),
            bases.build({}, {}, BaseUse::Scan).size());
}

}  // namespace
}  // namespace tapfit::updating
