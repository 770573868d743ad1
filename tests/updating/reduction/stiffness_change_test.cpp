// What elements have lost is a share of the stiffness they would have: it goes
// with the properties that are fitted beside it.
#include "updating/reduction/stiffness_change.hpp"

#include "tests/updating/support/sample_plate.hpp"
#include "updating/catalogue/catalogue.hpp"
#include "updating/fit/fitter.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <complex>

namespace tapfit::updating {
namespace {

using Eigen::MatrixXd;

class LossBesideModulus : public ::testing::Test,
                          protected support::BasedPlate {
 protected:
  [[nodiscard]] EffectInstance loss(double factor) const {
    EffectInstance effect{&effects::find("stiffness-loss"), {}, {factor}};
    effect.where.elements = {4, 5, 6, 14, 15, 16};
    return effect;
  }
  [[nodiscard]] FitProblem problem_at(const Eigen::VectorXcd& s) const {
    FitProblem problem;
    problem.context = context_;
    problem.measured = support::plate_pairs(bundle_, s);
    problem.targets = {make_target(problem.measured)};
    problem.uncertain_sd = {0.1};
    return problem;
  }
  [[nodiscard]] StiffnessTerm term() const {
    const EffectInstance effect = loss(0.5);
    StiffnessChange change;
    change.of = {effect.effect->name(), effect.where};
    return builder_.build({}, {change}).terms.front();
  }
};

// One material: E scales all of it.
TEST_F(LossBesideModulus, TermGoesWithTheModulus) {
  const StiffnessTerm one = term();
  const MatrixXd at = one.at({1.2});
  EXPECT_LT((one.at({1.0}) - one.S).norm(), 1e-12 * one.S.norm());
  EXPECT_LT((at - 1.2 * one.S).norm(), 1e-9 * one.S.norm());
  // Linear in E, so that differences are exact but for rounding.
  const MatrixXd slope = one.slope({1.2}, 0);
  EXPECT_LT((slope - (one.at({1.3}) - one.at({1.1})) / 0.2).norm(),
            1e-9 * one.S.norm());
}

// The derivative of FRFs by the modulus, beside a loss, against differences.
TEST_F(LossBesideModulus, FrfsChangeWithTheModulusAsDerived) {
  Eigen::VectorXcd s(3);
  s << std::complex<double>(5.0, 300.0), std::complex<double>(5.0, 700.0),
      std::complex<double>(5.0, 1500.0);
  const Fitter fitter(builder_, problem_at(s));
  const auto model = fitter.model_for({loss(0.5)});
  const auto at = [&](double modulus) {
    ModelState state = fitter.first_state(*model, {loss(0.3)});
    state.factor = {modulus};
    return state;
  };
  constexpr double step = 1e-4;
  // Factors are packed as logarithms.
  const Eigen::MatrixXcd differences =
      (model->respond(at(1.2 * std::exp(step)), s, false).H -
       model->respond(at(1.2 * std::exp(-step)), s, false).H) /
      (2.0 * step);
  const Eigen::MatrixXcd derived = model->respond(at(1.2), s, true).dH[0];
  // Differences are off by step^2 / 6 of the third derivative.
  EXPECT_LT((derived - differences).norm(), 1e-5 * differences.norm());
}

// The whole structure's stiffness times 1.2 moves all frequencies by its root,
// whatever elements have lost.
TEST_F(LossBesideModulus, FrequenciesGoWithItsRoot) {
  const Fitter fitter(builder_,
                      problem_at(Eigen::VectorXcd::Constant(1, {1.0, 200.0})));
  const auto model = fitter.model_for({loss(0.5)});
  ModelState state = fitter.first_state(*model, {loss(0.3)});
  state.factor = {1.0};
  const Eigen::VectorXd before = model->full_modes(state).omega;
  state.factor = {1.2};
  const Eigen::VectorXd after = model->full_modes(state).omega;
  for (Eigen::Index m = 0; m < 6; ++m) {
    EXPECT_NEAR(after(m) / before(m), std::sqrt(1.2), 1e-9) << m;
  }
}

}  // namespace
}  // namespace tapfit::updating
