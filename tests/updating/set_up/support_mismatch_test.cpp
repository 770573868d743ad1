#include "tests/updating/support/plate_model.hpp"
#include "updating/set_up/mistakes.hpp"

#include <Eigen/Geometry>
#include <gtest/gtest.h>

#include <algorithm>

namespace tapfit::effects {
namespace {

using updating::PlacedEffect;

// The clamped plate, its corner 55 held along an axis between Y and Z as well.
class TurnedSupport : public updating::PlateModel {
 protected:
  TurnedSupport() {
    held_.grids[held_.grid_index(55)].axes =
        Eigen::AngleAxisd(0.5, Eigen::Vector3d::UnitX()).toRotationMatrix();
    held_.constraints.push_back({55, "3"});
    corner_.nodes = {55};
    corner_.variant = "free";
  }

  [[nodiscard]] Setting setting() const {
    return support::plate_setting(bundle_, held_);
  }
  [[nodiscard]] Eigen::MatrixXcd frfs(
      const structure::Deck& deck,
      const std::vector<PlacedEffect>& effects) const {
    updating::FitSetting fit = fitter_->setting();
    fit.setting = support::plate_setting(bundle_, deck);
    const updating::BaseBuilder builder(deck,
                                        bundle_.uncertain,
                                        support::plate_base(bundle_, deck),
                                        Progress{});
    const updating::Fitter fitter(builder, fit);
    const auto model = fitter.model_for(effects);
    return model->respond(fitter.first_state(*model, effects), s_, false).H;
  }

  structure::Deck held_ = support::plate_deck(true);
  Where corner_;
};

TEST_F(TurnedSupport, IsFreeOfWhatItHoldsAlongItsOwnAxes) {
  const std::vector<Where> places = support_mismatch().places(setting());
  EXPECT_EQ(std::ranges::count(places, corner_), 1);
  const auto released = support_mismatch().released(corner_, setting());
  ASSERT_EQ(released.size(), 1U);
  EXPECT_EQ(released[0].grid, 55);
  EXPECT_EQ(released[0].components, "3");
  Where along = corner_;
  along.variant = "free-Z";
  EXPECT_EQ(std::ranges::count(places, along), 0) << "none of its axes";
}

TEST_F(TurnedSupport, FreedIsThePlateWithoutIt) {
  const Eigen::MatrixXcd plain = frfs(deck_, {});
  const Eigen::MatrixXcd held = frfs(held_, {});
  EXPECT_GT(updating::difference(held, plain), 0.1);
  const PlacedEffect free{&find("support-mismatch"), corner_, {}};
  // Static answers bring both bases to about 1e-6 of each other.
  EXPECT_LT(updating::difference(frfs(held_, {free}), plain), 1e-4);
}

}  // namespace
}  // namespace tapfit::effects
