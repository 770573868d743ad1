// What of several effects is taken off again.
#include "tests/updating/support/hidden_in_plate.hpp"
#include "updating/catalogue/catalogue.hpp"
#include "updating/diagnosis/forward_selection.hpp"
#include "updating/residual/independent_data.hpp"

#include <gtest/gtest.h>

#include <vector>

namespace tapfit::updating {
namespace {

class Prune : public support::HiddenInPlate {
 protected:
  // In the elements across the plate, counted from the clamp.
  static EffectInstance loss(int column, double left) {
    Location where;
    for (int j = 0; j < 4; ++j) where.elements.push_back(column + 10 * j);
    return {&effects::find("stiffness-loss"), where, {left}};
  }

  // A trace of something else: of what is fitted to the last digit no evidence
  // is left to be compared.
  static EffectInstance trace() {
    Location where;
    where.node = 28;
    return {&effects::find("added-mass"), where, {1e-3}};
  }

  // What stays of these, which are all there, under a floor.
  [[nodiscard]] std::vector<EffectInstance> kept(
      const std::vector<EffectInstance>& hidden, double floor) {
    std::vector<EffectInstance> all = hidden;
    all.push_back(trace());
    hide(all);
    const Fit fit = fitter_->fit(hidden, fitter_->model_for(hidden));
    DiagnoseOptions options;
    options.floor = floor;
    options.floor_noise = 0.01;
    std::vector<SelectedEffect> chosen(hidden.size());
    const double data =
        independent_data(fitter_->target(), fit.result.residual);
    return ForwardSelection(*fitter_, options)
        .prune(fit, 0, data, chosen, {})
        .effects;
  }
};

// An element between them is no distance; three are.
TEST_F(Prune, TakesWhatGivesWayAtOnePlaceForOneEffect) {
  EXPECT_EQ(kept({loss(2, 0.15), loss(4, 0.15)}, 0.5).size(), 1U);
  EXPECT_EQ(kept({loss(2, 0.15), loss(6, 0.15)}, 0.5).size(), 2U);
}

}  // namespace
}  // namespace tapfit::updating
