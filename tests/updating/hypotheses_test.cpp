#include "updating/hypotheses.hpp"

#include "tests/updating/support/sample_plate.hpp"
#include "updating/effects/catalogue.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace tapfit::updating {
namespace {

using Eigen::Index;

/// The sample plate's FRFs with an effect in it, and a fitter that has the
/// plate without.
class Hidden : public testing::Test {
 protected:
  void hide(const PlacedEffect& effect) {
    Eigen::VectorXcd s(60);
    for (Index l = 0; l < s.size(); ++l) {
      const double w = 2.0 * M_PI * (20.0 + 6.0 * static_cast<double>(l));
      s(l) = {0.03 * w, w};
    }
    FitSetting setting;
    setting.setting = support::plate_setting(bundle_, deck_);
    setting.measured = support::plate_pairs(bundle_, s);
    setting.targets = {make_target(setting.measured)};
    const Fitter blank(builder_, setting);
    const auto truth = blank.model_for({effect});
    const ModelState state = blank.first_state(*truth, {effect});
    const Eigen::MatrixXcd H = truth->respond(state, s, false).H;
    for (Index f = 0; f < H.cols(); ++f) {
      signal::Frf& frf = setting.measured.frfs[static_cast<std::size_t>(f)];
      frf.H = H.col(f);
      frf.variance = (0.01 * H.col(f).cwiseAbs()).cwiseAbs2();
    }
    setting.targets = {make_target(setting.measured)};
    fitter_.emplace(builder_, std::move(setting));
  }

  [[nodiscard]] std::vector<Hypothesis> tried(int neighbours) const {
    HypothesisOptions options;
    options.places_per_kind = 1;
    options.neighbours = neighbours;
    const Fit base = fitter_->fit({}, fitter_->model_for({}));
    std::vector<Hypothesis> all = fit_hypotheses(base, *fitter_, options, {});
    std::sort(all.begin(), all.end(), [](const auto& a, const auto& b) {
      return a.fit.result.error < b.fit.result.error;
    });
    return all;
  }

  structure::Deck deck_ = support::plate_deck(true);
  acquisition::TestBundle bundle_ = support::plate_bundle();
  BaseBuilder builder_{
      deck_, {}, support::plate_base(bundle_, deck_), Progress{}};
  std::optional<Fitter> fitter_;
};

TEST_F(Hidden, LossFarFromSmallIsFoundAtItsOwnPatch) {
  // Three by three elements with a fifth of their stiffness left: the first
  // order of the screening does not hold there.
  Where where;
  where.elements = {2, 3, 4, 12, 13, 14, 22, 23, 24};
  hide({&effects::find("stiffness-loss"), where, {0.2}});
  const Hypothesis best = tried(8).front();
  EXPECT_EQ(best.own().effect->name(), "stiffness-loss");
  EXPECT_EQ(best.own().where.elements, where.elements);
  // The same model made the FRFs; the fit stops within 1e-3 of its objective.
  EXPECT_NEAR(best.own().p[0], 0.2, 1e-3);
}

TEST_F(Hidden, LossOfALongStripIsFoundAsItIs) {
  // Six elements in line, which no cube holds alone.
  Where where;
  where.elements = {13, 14, 15, 16, 17, 18};
  hide({&effects::find("stiffness-loss"), where, {0.4}});
  const Hypothesis best = tried(8).front();
  EXPECT_EQ(best.own().effect->name(), "stiffness-loss");
  EXPECT_EQ(best.own().where.elements, where.elements);
  EXPECT_NEAR(best.own().p[0], 0.4, 1e-3);
}

TEST_F(Hidden, MassIsFoundAtItsOwnGrid) {
  Where where;
  where.node = 31;
  hide({&effects::find("added-mass"), where, {0.02}});
  const std::vector<Hypothesis> all = tried(8);
  const auto mass =
      std::find_if(all.begin(), all.end(), [](const Hypothesis& h) {
        return h.own().effect->name() == "added-mass";
      });
  ASSERT_NE(mass, all.end());
  EXPECT_EQ(mass->own().where.node, 31);
  EXPECT_NEAR(mass->own().p[0], 0.02, 2e-5);
}

}  // namespace
}  // namespace tapfit::updating
