#include "updating/localisation/run_drift.hpp"

#include "acquisition/bundle/runs_alike.hpp"
#include "tests/updating/support/plate_model.hpp"

#include <random>

namespace tapfit::updating {
namespace {

using Eigen::Index;

class RunDriftTest : public PlateModel {
 protected:
  /// Of those that are averaged together with it.
  double mean_run(std::size_t run) const {
    const auto groups = acquisition::runs_alike(bundle_);
    const auto& group = groups[acquisition::group_of(groups, run)];
    double sum = 0.0;
    for (const std::size_t r : group) sum += static_cast<double>(r);
    return sum / static_cast<double>(group.size());
  }

  /// The plate measured with a stiffness that changes evenly by `change` from
  /// the first run to the last, noise of 0.1 % of the peaks, and fitted.
  std::optional<RunDrift> found(double change, double noise = 0.001) {
    const auto model = fitter_->model_for({});
    const auto last = static_cast<double>(bundle_.runs.size()) - 1.0;
    std::mt19937 random(5);
    std::normal_distribution<double> normal;
    signal::FrfSet measured = pairs_;
    for (std::size_t f = 0; f < measured.frfs.size(); ++f) {
      signal::Frf& frf = measured.frfs[f];
      ModelState state = fitter_->first_state(*model, {});
      const double t = mean_run(frf.run) / last - 0.5;
      state.factor = {1.01 * std::exp(change * t)};
      frf.H = model->respond(state, s_, false).H.col(static_cast<Index>(f));
      const double level = noise * frf.H.norm() / std::sqrt(frf.H.size());
      for (auto& value : frf.H) {
        value += level * std::complex<double>(normal(random), normal(random));
      }
      frf.variance = Eigen::VectorXd::Constant(s_.size(), 2.0 * level * level);
    }
    FitProblem problem = fitter_->problem();
    problem.measured = measured;
    problem.targets = {make_target(measured)};
    const Fitter fitter(builder_, problem);
    const Fit fit = fitter.fit({}, fitter.model_for({}));
    return run_drift(fit, fitter.target());
  }
};

TEST_F(RunDriftTest, FindsAChangeAndItsSign) {
  for (const double change : {0.03, -0.03}) {
    const std::optional<RunDrift> drift = found(change);
    ASSERT_TRUE(drift.has_value());
    EXPECT_NEAR(drift->change, change, 0.1 * std::abs(change));
    EXPECT_TRUE(is_significant(*drift)) << drift->explained << " " << drift->sd;
    EXPECT_NE(statement(*drift).find(change > 0.0 ? "rises" : "falls"),
              std::string::npos);
  }
}

// The first point hit again at the end: its FRF is of the time between.
TEST_F(RunDriftTest, DatesAPointThatIsHitAgain) {
  bundle_.runs.push_back(bundle_.runs[0]);
  const std::optional<RunDrift> drift = found(0.03);
  ASSERT_TRUE(drift.has_value());
  EXPECT_NEAR(drift->change, 0.03, 0.1 * 0.03);
}

TEST_F(RunDriftTest, IsSilentWhereNothingChanges) {
  const std::optional<RunDrift> drift = found(0.0);
  ASSERT_TRUE(drift.has_value());
  EXPECT_LT(std::abs(drift->change), 4.0 * drift->sd);
  EXPECT_FALSE(is_significant(*drift));
}

TEST_F(RunDriftTest, IsNotLookedForWhereSensorsMove) {
  bundle_.runs[1].sensors[0].dof.node = 20;
  EXPECT_FALSE(found(0.03).has_value());
}

}  // namespace
}  // namespace tapfit::updating
