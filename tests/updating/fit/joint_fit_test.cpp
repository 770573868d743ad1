// Two tests of the sample plate, modulus 2 % above the deck's, fitted at once.
#include "updating/fit/joint_fit.hpp"

#include "tests/updating/support/plate_experiment.hpp"
#include "updating/catalogue/catalogue.hpp"
#include "updating/residual/independent_data.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <optional>
#include <vector>

namespace tapfit::updating {
namespace {

using Eigen::Index;

EffectInstance mass_of(double kg) {
  Location where;
  where.node = 25;
  return {&effects::find("added-mass"), where, {kg}};
}

// A test fitted by itself, whose modulus others share.
class Measured {
 public:
  Measured(unsigned seed,
           const std::vector<EffectInstance>& hidden,
           double form_allowance = 1.0,
           double noise = 0.02)
      : test_(hidden, noise, seed) {
    FitProblem problem = test_.fitter().problem();
    problem.form_allowance = form_allowance;
    fitter_.emplace(test_.fitter().with(problem));
    std::vector<EffectInstance> start = hidden;
    for (EffectInstance& effect : start) effect.p = {0.02};
    alone_ = fitter_->fit(start, fitter_->model_for(start));
  }

  [[nodiscard]] JointTest joint(double offset = 0.0) const {
    JointTest joint{&*fitter_, alone_, {}, {}};
    const Index count = pack(alone_.result.state).size();
    joint.shared.resize(static_cast<std::size_t>(count));
    joint.shared.front() = 0;
    joint.offset.setZero(count);
    joint.offset(0) = offset;
    return joint;
  }
  [[nodiscard]] const Fit& alone() const { return alone_; }
  // The test's share of the joint objective.
  [[nodiscard]] double misfit(const ModelState& state) const {
    const Target& target = fitter_->target();
    const Eigen::VectorXd r =
        residual(target, alone_.model->respond(state, target.s, false).H);
    return independent_data(target, alone_.result.residual) *
           std::log(r.squaredNorm());
  }

 private:
  PlateExperiment test_;
  std::optional<Fitter> fitter_;
  Fit alone_;
};

double modulus(const Fit& fit) { return fit.result.state.factor.front(); }
double sd_of(const Fit& fit, Index k) {
  return std::sqrt(fit.result.covariance(k, k));
}

TEST(JointFit, SharesOneNumberBetweenWhatTheTestsSayAlone) {
  const Measured a(3, {});
  const Measured b(4, {mass_of(0.05)});
  const JointFit joint = fit_together({a.joint(), b.joint()});
  ASSERT_TRUE(joint.converged) << joint.message;
  const double shared = modulus(joint.fits[0]);
  EXPECT_DOUBLE_EQ(shared, modulus(joint.fits[1]));
  EXPECT_GE(shared, std::min(modulus(a.alone()), modulus(b.alone())));
  EXPECT_LE(shared, std::max(modulus(a.alone()), modulus(b.alone())));
  EXPECT_NEAR(shared, 1.02, 2.0 * sd_of(joint.fits[0], 0));
  EXPECT_NEAR(
      joint.fits[1].effects[0].p[0],
      0.05,
      2.0 * 0.05 *
          sd_of(joint.fits[1], pack(joint.fits[1].result.state).size() - 1));
}

// A step of a tenth of a deviation either way costs (0.1)^2 of J, less what the
// other parameters would make up for.
TEST(JointFit, EndsWhereTheSumOfTheMisfitsIsLeast) {
  const Measured a(3, {});
  const Measured b(4, {mass_of(0.05)}, 1.0, 0.2);
  const JointFit joint = fit_together({a.joint(), b.joint()});
  const auto total = [&](double factor) {
    ModelState of_a = joint.fits[0].result.state;
    ModelState of_b = joint.fits[1].result.state;
    of_a.factor.front() *= factor;
    of_b.factor.front() *= factor;
    const double known = std::log(of_a.factor.front()) / 0.03;
    return a.misfit(of_a) + b.misfit(of_b) + known * known;
  };
  const double step = 0.1 * sd_of(joint.fits[0], 0);
  EXPECT_GT(total(std::exp(step)), total(1.0));
  EXPECT_GT(total(std::exp(-step)), total(1.0));
}

// Two decks with another value for one modulus.
TEST(JointFit, SharesTheValueAndNotTheFactor) {
  const Measured a(3, {});
  const Measured b(4, {});
  const JointFit joint = fit_together({a.joint(), b.joint(std::log(1.01))});
  EXPECT_NEAR(modulus(joint.fits[1]) / modulus(joint.fits[0]), 1.01, 1e-12);
}

// With the form known to be right the deviations are the noise's. Of 40
// intervals of 95 % with a chance of a thousandth 32 or fewer hold. Each is the
// wider of two estimates, so that they are rather too wide: the mean square of
// z is a quarter, as that of each test alone, and not next to nothing.
TEST(JointFit, StatesAsMuchAsItIsOffBy) {
  constexpr int pairs = 40;
  int hold = 0;
  double squares = 0.0;
  double narrower = 0.0;
  for (unsigned k = 0; k < pairs; ++k) {
    const Measured a(100 + 2 * k, {}, 1e-3);
    const Measured b(101 + 2 * k, {}, 1e-3);
    const JointFit joint = fit_together({a.joint(), b.joint()});
    const double sd = sd_of(joint.fits[0], 0);
    const double z = std::log(modulus(joint.fits[0]) / 1.02) / sd;
    hold += std::abs(z) < 1.96 ? 1 : 0;
    squares += z * z / pairs;
    narrower += sd / sd_of(a.alone(), 0) / pairs;
  }
  EXPECT_GT(hold, 32);
  EXPECT_GT(squares, 0.1);
  EXPECT_LT(squares, 1.7);
  EXPECT_NEAR(narrower, std::sqrt(0.5), 0.1);
}

TEST(Agreement, OfTwoIsTheirDifferenceInItsDeviations) {
  Eigen::VectorXd x(2);
  Eigen::VectorXd variance(2);
  x << 3.0, 5.0;
  variance << 0.4, 0.6;
  const Agreement both = agreement(x, variance);
  EXPECT_NEAR(both.q, 4.0, 1e-12);
  EXPECT_EQ(both.degrees, 1);
  EXPECT_NEAR(both.probability, std::erfc(std::sqrt(2.0)), 1e-9);
}

}  // namespace
}  // namespace tapfit::updating
