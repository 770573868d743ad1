#include "tui/views/update_view.hpp"

#include "tests/tui/support/canvases.hpp"
#include "tests/tui/support/fake_results.hpp"
#include "tests/tui/support/holds.hpp"
#include "tui/views/update_panels.hpp"
#include "updating/session/added_effect.hpp"

#include <gtest/gtest.h>

namespace tapfit::tui {
namespace {

TEST(UpdateView, SlidesFromTheLastModelToTheCurrentOne) {
  const signal::FrfSet frfs = testing::fake_frfs();
  const updating::Comparison before = testing::fake_comparison(0.05);
  const updating::Comparison after = testing::fake_comparison(0.0);
  const std::vector<updating::Rung> ladder{{"base", {}, 0.388, {}},
                                           {"added-mass", {}, 0.038, {}}};
  const std::vector<updating::Estimate> parameters{
      {"E:1", 7.07e10, 2.0e8, 7.03e10, 7.11e10}};
  const std::vector<updating::AddedEffect> effects{{{"added-mass", {}}, true},
                                                   {{"joint", {}}, false}};
  const UpdateInput input{
      frfs, ladder, parameters, effects, &before, &after, &before};
  UpdateState state;
  const Screen there = update_view(input, state, {});
  EXPECT_TRUE(holds(there, "error 38.8 % → 3.8 %")) << there.to_text();
  EXPECT_TRUE(holds(there, "(7.070 ± 0.020)e10"));
  EXPECT_TRUE(holds(there, "1 effect added")) << "the joint is off";
  state.slide = 0.0;
  EXPECT_NE(update_view(input, state, {}).to_text(), there.to_text());
}

TEST(UpdateView, EndsItsLadderWithTheFloor) {
  const signal::FrfSet frfs = testing::fake_frfs();
  const updating::Comparison now = testing::fake_comparison(0.0);
  const std::vector<updating::Rung> ladder{
      {"base", {}, 0.388, {}},
      {"soft-support", {.nodes = {1, 2, 3}, .variant = "rotation"}, 0.1, {}}};
  const std::vector<updating::AddedEffect> effects{
      {{"soft-support", ladder[1].where}, true}};
  acquisition::TestBundle bundle = testing::fake_bundle();
  bundle.uncertain = {{"material", 1, "E"}};
  structure::Deck deck = testing::fake_deck();
  deck.materials[1].E = 7.0e10;
  deck.shell_properties[1].membrane = 1;
  const std::vector<updating::Estimate> parameters{
      {"E:1", 6.87e10, 2.0e8, 6.83e10, 6.91e10}};
  UpdateInput input{frfs, ladder, parameters, effects, &now, &now};
  input.bundle = &bundle;
  input.deck = &deck;
  const Screen s = update_view(input, {}, {160, 40});
  EXPECT_TRUE(holds(s, "floor  ")) << s.to_text();
  EXPECT_TRUE(holds(s, "3.1 %")) << s.to_text();
  EXPECT_TRUE(holds(s, "to the deck")) << s.to_text();
  EXPECT_TRUE(holds(s, "−1.86 %")) << s.to_text();
  EXPECT_TRUE(holds(s, "soft-support rotation, nodes 1, 2, 3")) << s.to_text();
}

TEST(UpdateView, MarksTheLatestEffectAndShowsItsFit) {
  const signal::FrfSet frfs = testing::fake_frfs();
  const std::vector<updating::Rung> ladder{
      {"base", {}, 0.388, {}},
      {updating::uncertain_rung, {}, 0.3, {}},
      {"added-mass", {}, 0.1, {}},
      {"joint", {}, 0.038, {}}};
  const auto record = [](const char* added) {
    updating::UpdateRecord of;
    of.added = added;
    return of;
  };
  const std::vector<updating::UpdateRecord> records{
      record(updating::uncertain_rung), record("added-mass"), record("joint")};
  std::vector<updating::AddedEffect> effects{{{"added-mass", {}}, true},
                                             {{"dashpot", {}}, false},
                                             {{"joint", {}}, true}};
  const UpdateInput input{
      frfs, ladder, {}, effects, nullptr, nullptr, nullptr, &records};
  UpdateState state;
  state.panel = UpdateState::Panel::Convergence;
  Screen s = update_view(input, state, {});
  EXPECT_TRUE(holds(s, "▸joint")) << s.to_text();
  EXPECT_TRUE(holds(s, "fit with joint")) << s.to_text();
  state.effect = 0;
  s = update_view(input, state, {});
  EXPECT_TRUE(holds(s, "▸added-mass")) << s.to_text();
  EXPECT_TRUE(holds(s, "fit with added-mass")) << s.to_text();
  state.effect = 1;  // is off: the model it would be added to
  EXPECT_TRUE(holds(update_view(input, state, {}), "fit with added-mass"));
}

TEST(UpdateView, ShowsWhatTheMarkedEffectDoes) {
  const signal::FrfSet frfs = testing::fake_frfs();
  const acquisition::TestBundle bundle = testing::fake_bundle();
  const structure::Deck deck = testing::fake_deck();
  const Wireframe wire = wireframe(deck);
  const updating::EffectEvidence evidence = updating::effect_evidence(
      testing::fake_comparison(0.05), testing::fake_comparison(0.0));
  const std::vector<updating::Rung> ladder{{"base", {}, 0.388, {}},
                                           {"stiffness-loss", {}, 0.038, {}}};
  const std::vector<updating::AddedEffect> effects{
      {{"stiffness-loss", {.elements = {2}}}, true}};
  UpdateInput input{frfs, ladder, {}, effects};
  input.evidence = &evidence;
  input.bundle = &bundle;
  input.deck = &deck;
  input.wire = &wire;
  input.look_alikes = "indistinguishable from nothing";
  UpdateState state;
  state.panel = UpdateState::Panel::Evidence;
  for (const Canvas& canvas : sizes) {
    const Screen s = update_view(input, state, canvas);
    EXPECT_TRUE(holds(s, "┈ without  ╌ with")) << s.to_text();
    EXPECT_TRUE(holds(s, "error 38.8 % without it, 0.01 % with it"));
    EXPECT_TRUE(holds(s, "●")) << s.to_text();
    EXPECT_TRUE(holds(s, "indistinguishable from nothing")) << s.to_text();
  }
  state.uncertain = true;
  EXPECT_TRUE(holds(update_view(input, state, sizes[1]),
                    "uncertain properties, before any effect"));
  state.uncertain = false;
  updating::UpdateRecord record;
  record.correlation = Eigen::MatrixXd::Identity(1, 1);
  record.parameters = {"stiffness-loss factor"};
  const std::vector<updating::UpdateRecord> records{record};
  input.records = &records;
  state.panel = UpdateState::Panel::Correlation;
  EXPECT_TRUE(holds(update_view(input, state, sizes[1]),
                    "The effect is indistinguishable from nothing"));
}

// Names give way on the smallest screen, numbers and units do not.
TEST(UpdateView, CutsNoValue) {
  const signal::FrfSet frfs = testing::fake_frfs();
  const std::vector<updating::Rung> ladder{{updating::base_rung, {}, 0.8, {}},
                                           {"sensor-mass", {}, 0.1, {}},
                                           {"soft-support", {}, 0.004, {}}};
  const std::vector<updating::Estimate> found{
      {"E:1", 6.8686e10, 6.8e7, 6.855e10, 6.882e10},
      {"sensor-mass mass_kg", 0.02005, 0.00016, 0.0197, 0.0204},
      {"soft-support rotational_stiffness_nm_per_rad_per_m",
       2997.0,
       32.0,
       2934.0,
       3060.0}};
  const std::vector<updating::AddedEffect> effects{
      {{"sensor-mass", {}}, true}, {{"soft-support", {}}, true}};
  const Screen s = update_view(
      {frfs, ladder, found, effects, nullptr, nullptr, nullptr}, {}, sizes[0]);
  for (const char* value : {"(6.8686 ± 0.0068)e10 Pa",
                            "0.02005 ± 0.00016 kg",
                            "2997 ± 32 N m/rad/m"}) {
    EXPECT_TRUE(holds(s, value)) << value << s.to_text();
  }
}

TEST(UpdateView, MarksAFitThatWasKeptEarly) {
  const signal::FrfSet frfs = testing::fake_frfs();
  std::vector<updating::Rung> ladder{{"base", {}, 0.388, {}},
                                     {"added-mass", {}, 0.038, {}}};
  const std::vector<updating::AddedEffect> effects{{{"added-mass", {}}, true}};
  const UpdateInput input{frfs, ladder, {}, effects, nullptr, nullptr, nullptr};
  EXPECT_FALSE(holds(update_view(input, {}, {}), "kept"));
  ladder[1].stopped_after = 7;
  for (const Canvas& canvas : sizes) {
    const Screen s = update_view(input, {}, canvas);
    EXPECT_TRUE(holds(s, "3.8 %, kept early")) << s.to_text();
    EXPECT_TRUE(holds(s, " kept\n")) << s.to_text();
  }
}

// A stage is on lines of its own: no line leads up to its first error.
TEST(UpdateView, DrawsTheConvergenceOfEachStageByItself) {
  updating::UpdateRecord record;
  record.added = "added-mass";
  for (int k = 0; k < 6; ++k) {
    record.steps.push_back(
        {k < 3 ? 0 : 1, k % 3 == 0 ? 1.0 : 0.001, 0.0, 0.0, {}});
  }
  const auto dots_between = [&record] {
    Screen s(80, 24);
    draw_convergence(s, s.area(), record);
    int count = 0;
    for (int y = 2; y < 10; ++y) {
      for (int x = 40; x < 50; ++x) {  // step 2 to 3
        const char32_t glyph = s.at(x, y).glyph;
        count += glyph > U'\u2800' && glyph <= U'\u28ff' ? 1 : 0;
      }
    }
    return count;
  };
  EXPECT_EQ(dots_between(), 0);
  for (updating::RecordedStep& step : record.steps) step.stage = 0;
  EXPECT_GT(dots_between(), 0);
}

}  // namespace
}  // namespace tapfit::tui
