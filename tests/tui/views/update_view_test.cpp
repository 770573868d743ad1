#include "tui/views/update_view.hpp"

#include "tests/tui/support/fake_results.hpp"
#include "updating/session/added_effect.hpp"

#include <gtest/gtest.h>

namespace tapfit::tui {
namespace {

const std::vector<Canvas> sizes{{80, 21, false}, {120, 32, false}};

bool holds(const Screen& screen, const std::string& part) {
  return screen.to_text().find(part) != std::string::npos;
}

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

}  // namespace
}  // namespace tapfit::tui
