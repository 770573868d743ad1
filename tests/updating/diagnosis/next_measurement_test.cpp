#include "updating/diagnosis/next_measurement.hpp"

#include "tests/updating/support/sample_plate.hpp"
#include "updating/catalogue/catalogue.hpp"
#include "updating/measurement/damped_line.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <optional>

namespace tapfit::updating {
namespace {

constexpr double floor = 0.01;

// The sample plate, measured along its middle (grids 23 to 33) alone: it is
// its own mirror image there, and sees no torsion.
class NextMeasurementTest : public ::testing::Test {
 protected:
  NextMeasurementTest()
      : deck_(support::plate_deck(true)), bundle_(support::plate_bundle()) {
    int hit = 28;
    for (acquisition::Run& run : bundle_.runs) {
      run.hammer.dof.node = std::min(hit++, 33);
      run.sensors[0].dof.node = 33;
      run.sensors[1].dof.node = 29;
    }
    builder_.emplace(deck_,
                     bundle_.uncertain,
                     support::plate_base(bundle_, deck_),
                     Progress{});
    FitProblem fit;
    fit.context = support::plate_context(bundle_, deck_);
    fit.uncertain_sd = {0.03};
    fit.measured = support::plate_pairs(
        bundle_, damped_line({10.0, 400.0}, 3.0, {0.03, 120}));
    // The level that differences are measured by is the base model's own.
    fit.targets = {make_target(fit.measured)};
    const Fitter bare(*builder_, fit);
    const auto model = bare.model_for({});
    const Eigen::MatrixXcd H =
        model->respond(bare.first_state(*model, {}), fit.measured.s, false).H;
    for (Eigen::Index f = 0; f < H.cols(); ++f) {
      fit.measured.frfs[static_cast<std::size_t>(f)].H = H.col(f);
    }
    fit.targets = {make_target(fit.measured)};
    fitter_.emplace(*builder_, fit);
  }

  [[nodiscard]] Fit with(const std::string& effect,
                         const Location& where,
                         double size) const {
    Fit fit;
    fit.effects = {{&effects::find(effect), where, {size}}};
    fit.model = fitter_->model_for(fit.effects);
    fit.result.state = fitter_->first_state(*fit.model, fit.effects);
    return fit;
  }

  structure::Deck deck_;
  acquisition::TestBundle bundle_;
  std::optional<BaseBuilder> builder_;
  std::optional<Fitter> fitter_;
};

Location grid(int node) {
  Location where;
  where.node = node;
  return where;
}

// Grids 9 and 53 are mirror images: no FRF of the middle tells a mass on one
// from a mass on the other, any FRF with a point off it does.
TEST_F(NextMeasurementTest, LeavesTheLineOfSymmetry) {
  const auto next = next_measurement(with("added-mass", grid(9), 0.02),
                                     with("added-mass", grid(53), 0.02),
                                     *fitter_);
  ASSERT_TRUE(next);
  // Rounding of the reduced base.
  EXPECT_LT(next->difference_now, 1e-6);
  EXPECT_TRUE(is_significant(*next, floor));
  const auto on_middle = [](const Dof& dof) {
    return dof.node >= 23 && dof.node <= 33;
  };
  EXPECT_FALSE(on_middle(next->hit) && on_middle(next->sensor));
  EXPECT_EQ(next->one.where.node, 9);
  EXPECT_EQ(next->other.where.node, 53);
  EXPECT_NE(advice(*next, floor).find("hit "), std::string::npos);
}

// While the sensor stays, its mass and a mass beneath it are one thing. It
// must be moved, by whatever FRF.
TEST_F(NextMeasurementTest, MovesTheSensorWhoseMassItMayBe) {
  Location channel;
  channel.channels = {"acc1"};
  const auto next = next_measurement(with("sensor-mass", channel, 0.02),
                                     with("added-mass", grid(33), 0.02),
                                     *fitter_);
  ASSERT_TRUE(next);
  EXPECT_LT(next->difference_now, 1e-6);
  EXPECT_TRUE(next->moves_sensor);
  EXPECT_EQ(next->channel, "acc1");
  EXPECT_TRUE(is_significant(*next, floor));
}

TEST_F(NextMeasurementTest, SaysWhenNoPointTells) {
  const auto next = next_measurement(with("added-mass", grid(9), 0.02),
                                     with("added-mass", grid(9), 0.02),
                                     *fitter_);
  ASSERT_TRUE(next);
  EXPECT_FALSE(is_significant(*next, floor));
  EXPECT_NE(advice(*next, floor).find("no hit or sensor point"),
            std::string::npos);
}

}  // namespace
}  // namespace tapfit::updating
