#include "tests/updating/support/plate_model.hpp"
#include "updating/frf_model/frf_model.hpp"

#include <gtest/gtest.h>

#include <string>
#include <vector>

namespace tapfit::updating {
namespace {

using FrfResponses = PlateModel;

// With a mass in the modes, a gain in the chain, and each of these last.
TEST_F(FrfResponses, AtSizesOfTheLastEffectAreThoseOfEachSize) {
  const auto of_channel = [](const std::string& name, double p) {
    Location where;
    where.channels = {"acc1"};
    return EffectInstance{&effects::find(name), where, {p}};
  };
  const std::vector<EffectInstance> lasts = {of_channel("channel-delay", 1e-4),
                                             at_node("added-mass", 30, 0.05),
                                             at_node("dashpot", 20, 7.0),
                                             sensors(0.01, 0.02),
                                             clamp(1e3)};
  for (const EffectInstance& last : lasts) {
    std::vector<EffectInstance> effects = {
        at_node("added-mass", 50, 0.02), of_channel("channel-gain", 1.3), last};
    const auto model = fitter_->model_for(effects);
    ModelState state = fitter_->first_state(*model, effects);
    std::vector<std::vector<double>> sizes;
    for (const double factor : {0.3, 1.0, 4.0}) {
      sizes.push_back(last.p);
      for (double& p : sizes.back()) p *= factor;
    }
    const auto H = model->respond_at_sizes(state, sizes, s_);
    ASSERT_EQ(H.size(), sizes.size());
    for (std::size_t k = 0; k < sizes.size(); ++k) {
      state.effects.back().p = sizes[k];
      EXPECT_LT(difference(H[k], model->respond(state, s_, false).H), 1e-12)
          << last.effect->name();
    }
  }
}

// With a mass and a gain on top.
TEST_F(FrfResponses, ThroughOtherModesAreThoseOfAModelThatHasThem) {
  Location channel;
  channel.channels = {"acc1"};
  const std::vector<EffectInstance> effects = {
      at_node("added-mass", 50, 0.02),
      {&effects::find("channel-gain"), channel, {1.3}}};
  const auto model = fitter_->model_for(effects);
  ModelState state = fitter_->first_state(*model, effects);
  BaseModes modes = model->base_modes(state);
  EXPECT_LT(difference(model->respond_through(modes, state, s_),
                       model->respond(state, s_, false).H),
            1e-12);
  // The one stiffness that is uncertain is that of the whole plate.
  modes.omega *= 1.02;
  state.factor = {1.02 * 1.02};
  EXPECT_LT(difference(model->respond_through(modes, state, s_),
                       model->respond(state, s_, false).H),
            1e-9);
}

TEST_F(FrfResponses, OfACorrectedSheetAreNotScaledOnes) {
  for (const char* name : {"channel-swap", "point-mislabelled"}) {
    const effects::Effect& mistake = effects::find(name);
    const std::vector<Location> places = mistake.places(context_);
    ASSERT_FALSE(places.empty());
    Location where = places.front();
    if (mistake.takes_any_grid()) {
      where.node = where.nodes.front() == 30 ? 20 : 30;
    }
    const std::vector<EffectInstance> effects = {{&mistake, where, {}}};
    const auto model = fitter_->model_for(effects);
    const ModelState state = fitter_->first_state(*model, effects);
    const auto corrected = model->respond(state, s_, false).H;
    const auto at = model->respond_at_sizes(state, {{}}, s_);
    ASSERT_EQ(at.size(), 1U) << name;
    EXPECT_LT(difference(at.front(), corrected), 1e-12) << name;
    EXPECT_TRUE(model->respond_at_sizes(state, {}, s_).empty()) << name;
    const auto plain =
        model->respond(fitter_->first_state(*model, {}), s_, false).H;
    EXPECT_GT(difference(plain, corrected), 1e-3) << name;
  }
}

}  // namespace
}  // namespace tapfit::updating
