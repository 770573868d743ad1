#include "updating/reduction/lean_span.hpp"

#include "tests/updating/support/sample_plate.hpp"
#include "updating/catalogue/catalogue.hpp"
#include "updating/frf_model/acted_points.hpp"
#include "updating/frf_model/frf_model.hpp"
#include "updating/measurement/damped_line.hpp"

#include <gtest/gtest.h>

#include <cmath>
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

// A plate that is held all round may turn and move there by itself in more than
// a hundred ways: fits get the few patterns of them that the band moves.
TEST_F(LeanSpan, AnswersAsTheWholeBaseWhereHundredsGiveWay) {
  bundle_.uncertain = {{"property", 1, "t", 5.0}};
  Location edge;
  deck_.constraints.clear();
  for (const structure::Grid& grid : deck_.grids) {
    const int column = (grid.id - 1) % 11;
    const int row = (grid.id - 1) / 11;
    if (column % 10 != 0 && row % 4 != 0) continue;
    deck_.constraints.push_back({grid.id, "123456"});
    edge.nodes.push_back(grid.id);
  }
  edge.variant = "both";
  for (acquisition::Run& run : bundle_.runs) {
    run.sensors = {{1, {14, 3, 1}}, {2, {36, 3, -1}}};
    if (run.hammer.dof.node != 36) run.hammer.dof.node = 19;
  }
  BaseOptions options = support::plate_base(bundle_, deck_);
  options.split = true;
  options.high_hz = 1000.0;
  const BaseBuilder bases(deck_, bundle_.uncertain, options, Progress{});
  const StiffnessChange change{
      ChangeKind::Support, {"soft-support", edge}, context_.component};
  const FrfModel wide = model(bases.build({}, {change}, BaseUse::Scan));
  const FrfModel narrow = model(bases.build({}, {change}, BaseUse::Fit));
  EXPECT_LT(narrow.base().size(), wide.base().size());
  const std::vector<StiffnessTerm>& terms = narrow.base().terms;
  ASSERT_EQ(terms.size(), 2u);
  const auto size_at = [](const StiffnessTerm& term, double share) {
    return std::pow(term.lower, 1.0 - share) * std::pow(term.upper, share);
  };
  const Eigen::VectorXcd s = damped_line({100.0, 1000.0}, 10.0, {0.03, 80});
  for (const double share : {0.0, 0.25, 0.5, 0.75, 1.0}) {
    ModelState state;
    state.factor = {1.0};
    state.effects = {{&effects::find("soft-support"),
                      edge,
                      {size_at(terms[0], share), size_at(terms[1], 0.7)}}};
    const Eigen::MatrixXcd whole = wide.respond(state, s, false).H;
    const Eigen::MatrixXcd lean = narrow.respond(state, s, false).H;
    EXPECT_LT((lean - whole).norm(), 1e-4 * whole.norm()) << share;
  }
}

// At grids that fits do not ask about a base is made again as it was, also
// where its builder is gone.
TEST_F(LeanSpan, KnowsTheGridsThatItDoesNotKeep) {
  Location clamp;
  clamp.nodes = {1, 12, 23, 34, 45};
  clamp.variant = "rotation";
  const std::vector<StiffnessChange> changes = {
      {ChangeKind::Support, {"soft-support", clamp}, context_.component}};
  BaseOptions options = support::plate_base(bundle_, deck_);
  const auto base = [&](bool whole) {
    options.on_two_meshes = whole;
    const BaseBuilder bases(deck_, bundle_.uncertain, options, Progress{});
    return bases.build({}, changes, BaseUse::Fit);
  };
  const ReducedBase kept = base(true);
  const ReducedBase asked = base(false);
  EXPECT_LT(20 * asked.rows.own_numbers(), kept.rows.own_numbers());
  EXPECT_EQ(asked.rows.row(options.points.front()),
            kept.rows.row(options.points.front()));
  EXPECT_EQ(asked.rows.all(), kept.rows.all());
}

// Two effects at once, each anywhere in its range: the span was made from few
// of these settings.
TEST_F(LeanSpan, AnswersAsTheWholeBaseWhereTwoThingsGiveWay) {
  bundle_.uncertain = {{"property", 1, "t", 5.0}};
  const BaseBuilder bases = builder();
  Location patch;
  patch.elements = {12, 13, 14, 22, 23, 24};
  Location clamp;
  clamp.nodes = {1, 12, 23, 34, 45};
  clamp.variant = "both";
  const int component = context_.component;
  const std::vector<StiffnessChange> changes = {
      {ChangeKind::Support, {"soft-support", clamp}, component},
      {ChangeKind::Elements, {"stiffness-loss", patch}, component}};
  const FrfModel wide = model(bases.build({}, changes, BaseUse::Scan));
  const FrfModel narrow = model(bases.build({}, changes, BaseUse::Fit));
  const std::vector<StiffnessTerm>& terms = narrow.base().terms;
  ASSERT_EQ(terms.size(), 3u);
  EXPECT_LT(narrow.base().size(), wide.base().size());
  const auto part = [](const StiffnessTerm& term, double share) {
    return term.lower * std::pow(term.upper / term.lower, share);
  };
  // Where the clamp is a hinge and next to nothing is left of the patch, the
  // structure is another, and moves as some of what the lean base has dropped.
  for (const auto& [turns, moves, left, least] :
       {std::tuple{0.15, 0.5, 0.8, 5e-4},
        std::tuple{0.3, 1.0, 0.1, 5e-4},
        std::tuple{0.5, 0.15, 0.3, 5e-3},
        std::tuple{0.0, 0.0, 0.0, 5e-3}}) {
    ModelState state;
    state.factor = {1.05};
    state.effects = {
        {&effects::find("soft-support"),
         clamp,
         {part(terms[0], turns), part(terms[1], moves)}},
        {&effects::find("stiffness-loss"), patch, {part(terms[2], left)}}};
    const Eigen::MatrixXcd whole = respond(wide, state);
    const Eigen::MatrixXcd lean = respond(narrow, state);
    EXPECT_LT((lean - whole).norm(), least * whole.norm()) << turns;
  }
}

// The fit's slopes are those of what it fits, whatever the span.
TEST_F(LeanSpan, ItsSlopesAreThoseOfTheWholeBase) {
  const BaseBuilder bases = builder();
  Location clamp;
  clamp.nodes = {1, 12, 23, 34, 45};
  clamp.variant = "rotation";
  const StiffnessChange change{
      ChangeKind::Support, {"soft-support", clamp}, context_.component};
  const FrfModel wide = model(bases.build({}, {change}, BaseUse::Scan));
  const FrfModel narrow = model(bases.build({}, {change}, BaseUse::Fit));
  ModelState state;
  state.factor = {1.0, 1.0, 1.0, 1.0};
  state.effects = {{&effects::find("soft-support"),
                    clamp,
                    {narrow.base().terms.front().start}}};
  const ModelResponse whole = wide.respond(state, s_, true);
  const ModelResponse lean = narrow.respond(state, s_, true);
  ASSERT_EQ(lean.dH.size(), whole.dH.size());
  for (std::size_t j = 0; j < whole.dH.size(); ++j) {
    // Tenths of a percent do not turn a step of a fit.
    EXPECT_LT((lean.dH[j] - whole.dH[j]).norm(), 2e-3 * whole.dH[j].norm())
        << j;
  }
}

// One clamp after the other, and the first again: each gets its own.
TEST_F(LeanSpan, BasesThatAreKeptAreThoseAskedFor) {
  bundle_.uncertain.clear();
  const BaseBuilder bases = builder();
  const auto build = [&](const char* variant) {
    Location clamp;
    clamp.nodes = {1, 12, 23, 34, 45};
    clamp.variant = variant;
    return bases.build(
        {},
        {{ChangeKind::Support, {"soft-support", clamp}, context_.component}},
        BaseUse::Fit);
  };
  const ReducedBase turns = build("rotation");
  const ReducedBase moves = build("translation");
  const ReducedBase again = build("rotation");
  EXPECT_EQ(again.K, turns.K);
  EXPECT_EQ(again.terms.front().of.where.variant, "rotation");
  EXPECT_EQ(moves.terms.front().of.where.variant, "translation");
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
