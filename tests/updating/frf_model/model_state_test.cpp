#include "updating/frf_model/model_state.hpp"

#include "updating/catalogue/catalogue.hpp"

#include <gtest/gtest.h>

namespace tapfit::updating {
namespace {

ModelState state_with(const EffectInstance& effect) {
  ModelState state;
  state.factor = {1.02};
  state.zeta_other = 0.007;
  state.effects = {effect};
  return state;
}

TEST(ModelState, PackAndUnpackAreInverse) {
  ModelState state = state_with({&effects::find("added-mass"), {}, {0.05}});
  state.zeta = Eigen::VectorXd::LinSpaced(3, 0.004, 0.02);
  EXPECT_EQ(pack(state).size(), state.parameters());
  const ModelState back = unpack(state, pack(state));
  EXPECT_DOUBLE_EQ(back.factor[0], 1.02);
  EXPECT_TRUE(back.zeta.isApprox(state.zeta, 1e-14));
  EXPECT_NEAR(back.effects[0].p[0], 0.05, 1e-15);
}

// zeta = (alpha / omega + beta omega + eta) / 2.
TEST(ModelState, ALawGivesEveryModeItsRatio) {
  const ModelState state =
      state_with({&effects::find("damping-law"), {}, {4.0, 2e-6, 0.01}});
  for (const double w : {50.0, 700.0}) {
    EXPECT_DOUBLE_EQ(state.zeta_at(w), 0.5 * (4.0 / w + 2e-6 * w + 0.01));
  }
  EXPECT_EQ(
      state_with({&effects::find("added-mass"), {}, {0.05}}).zeta_at(50.0),
      0.007);
}

}  // namespace
}  // namespace tapfit::updating
