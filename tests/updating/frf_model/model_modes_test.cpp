#include "updating/frf_model/model_modes.hpp"

#include "tests/updating/support/plate_model.hpp"

#include <Eigen/LU>

#include <cmath>
#include <complex>

namespace tapfit::updating {
namespace {

using Eigen::Index;
using Eigen::MatrixXcd;
using Eigen::VectorXcd;
using std::complex;

class ModelModesTest : public PlateModel {
 protected:
  /// How far the model's FRFs are from the sum over its modes, each with a
  /// damping ratio of its own.
  double off_definition(const FrfModel& model,
                        const std::vector<EffectInstance>& effects) const {
    ModelState state = fitter_->first_state(model, effects);
    for (Index q = 0; q < state.zeta.size(); ++q) {
      state.zeta(q) = 0.002 * static_cast<double>(1 + (5 * q) % 7);
    }
    MatrixXcd expected =
        MatrixXcd::Zero(s_.size(), static_cast<Index>(pairs_.frfs.size()));
    add_modes(model, state, model.full_modes(state), expected);
    return difference(model.respond(state, s_, false).H, expected);
  }

  /// The definition of a modal damping ratio, mode by mode.
  void add_modes(const FrfModel& model,
                 const ModelState& state,
                 const BaseModes& modes,
                 MatrixXcd& expected) const {
    for (Index m = 0; m < modes.omega.size(); ++m) {
      const double w = modes.omega(m);
      const double zeta =
          m < state.zeta.size() ? state.zeta(m) : state.zeta_other;
      const VectorXcd answer =
          (s_.array().square() /
           (s_.array().square() + 2.0 * zeta * w * s_.array() + w * w))
              .matrix();
      for (std::size_t f = 0; f < pairs_.frfs.size(); ++f) {
        const auto at = [&](const Dof& dof) {
          return dof.sign *
                 model.row(dof.node, dof.component).dot(modes.phi.col(m));
        };
        expected.col(static_cast<Index>(f)) +=
            at(pairs_.frfs[f].response) * at(pairs_.frfs[f].reference) * answer;
      }
    }
  }
};

// The definition of a modal damping ratio, mode by mode of the structure with
// its springs and masses: R_r = phi phi' / (s^2 + 2 zeta w s + w^2).
TEST_F(ModelModesTest, DampingRatiosBelongToTheModesWithSpringsAndMasses) {
  const std::vector<EffectInstance> effects = {
      at_node("ground-spring", 50, 3e5),
      at_node("added-mass", 30, 0.05),
      sensors(0.01, 0.02)};
  const auto model = fitter_->model_for(effects);
  EXPECT_LT(off_definition(*model, effects), 1e-9);
}

// The lowest keeps what the lowest had, wherever it stands.
TEST(ByOrder, FollowsTheFrequencies) {
  const Eigen::Vector3d before(10.0, 30.0, 20.0);
  const Eigen::Vector3d after(21.0, 11.0, 31.0);
  EXPECT_EQ(by_order({5, 6, 7}, before, after), (std::vector<int>{7, 5, 6}));
  EXPECT_EQ(by_order({5, 6, 7}, before, before), (std::vector<int>{5, 6, 7}));
}

// What goes into the modes is what its law says at every s.
TEST_F(ModelModesTest, LosslessLawsAreSpringsAndMasses) {
  int lossless = 0;
  const auto check = [](const effects::Effect& effect,
                        std::size_t k,
                        const std::vector<double>& p,
                        std::size_t group) {
    std::vector<double> without = p;
    without[k] = 0.0;
    const double stiffness = effect.law_derivative(0.0, p, group, k).real();
    const double mass =
        effect.law_derivative(1.0, p, group, k).real() - stiffness;
    for (const complex<double> s :
         {complex<double>(30.0, 500.0), complex<double>(2.0, 900.0)}) {
      const complex<double> law = effect.law(s, p, group);
      const complex<double> sum =
          effect.law(s, without, group) + p[k] * (stiffness + s * s * mass);
      EXPECT_LT(std::abs(law - sum), 1e-12 * std::abs(law)) << effect.name();
    }
  };
  for (const effects::Effect* effect : effects::catalogue()) {
    if (effect->changes_stiffness()) continue;
    for (const Location& where : effect->places(context_)) {
      std::vector<double> p;
      for (const auto& spec : effect->parameters(where, context_)) {
        p.push_back(spec.start * (1.0 + 0.3 * static_cast<double>(p.size())));
      }
      for (std::size_t k = 0; k < p.size(); ++k) {
        if (!effect->is_lossless(k)) continue;
        if (where == effect->places(context_).front()) ++lossless;
        for (const auto& dof : effect->interface_dofs(where, context_, 0)) {
          check(*effect, k, p, dof.group);
        }
      }
    }
  }
  // added-mass, ground-spring, sensor-mass, the spring of sensor-cable
  EXPECT_EQ(lossless, 4);
}

// A cable's spring turns the modes that have the ratios; its damper, if there
// is next to none, adds nothing.
TEST_F(ModelModesTest, ACablesSpringIsInTheModesThatRatiosBelongTo) {
  Location where;
  where.channels = {"acc1", "acc2"};
  const EffectInstance cable{
      &effects::find("sensor-cable"), where, {2e4, 1e-9}};
  const auto model = fitter_->model_for({cable});
  EXPECT_LT(off_definition(*model, {cable}), 1e-8);
}

TEST_F(ModelModesTest, FullModesFallWithAddedMass) {
  const std::vector<EffectInstance> effects = {at_node("added-mass", 33, 0.1)};
  const auto model = fitter_->model_for(effects);
  const Eigen::VectorXd base =
      model->full_modes(fitter_->first_state(*model, {})).omega;
  const Eigen::VectorXd loaded =
      model->full_modes(fitter_->first_state(*model, effects)).omega;
  EXPECT_LT(loaded(0), 0.95 * base(0));
}

// Measured modes of several set-ups are means; so are the model's, whichever
// run comes first.
TEST_F(ModelModesTest, FullModesWithARovingMassAreMeansOverTheRuns) {
  constexpr double mass = 0.004;  // 1.4 % of the plate
  const std::vector<int> nodes = {11, 36, 52, 28, 6, 42};
  for (std::size_t run = 0; run < nodes.size(); ++run) {
    bundle_.runs[run].sensors[0].dof.node = nodes[run];
  }
  Location where;
  where.channels = {"acc1"};
  const std::vector<EffectInstance> roving = {
      {&effects::find("sensor-mass"), where, {mass}}};
  const auto model = fitter_->model_for(roving);
  const Eigen::VectorXd found =
      model->full_modes(fitter_->first_state(*model, roving)).omega;
  Eigen::VectorXd mean = Eigen::VectorXd::Zero(6);
  for (const int node : nodes) {
    const std::vector<EffectInstance> there = {
        at_node("added-mass", node, mass)};
    const auto still = fitter_->model_for(there);
    mean +=
        still->full_modes(fitter_->first_state(*still, there)).omega.head(6);
  }
  mean /= static_cast<double>(nodes.size());
  for (Index m = 0; m < 6; ++m) {
    // Of second order in shifts of up to 5 %.
    EXPECT_NEAR(found(m), mean(m), 2e-3 * mean(m));
  }
}

// Modes of the plate with an absorber are one more than without, and each obeys
//
//   (Omega^2 - w^2 + b z(j w) b') q = 0,   z = -m w^2 w_a^2 / (w_a^2 - w^2).
TEST_F(ModelModesTest, FullModesHaveAnAbsorbersOwn) {
  Location where;
  where.node = 33;
  for (const double hz : {20.0, 63.0, 120.0}) {
    constexpr double mass = 0.1;
    const std::vector<EffectInstance> effects = {
        {&effects::find("absorber"), where, {mass, hz, 0.01}}};
    const auto model = fitter_->model_for(effects);
    const ModelState state = fitter_->first_state(*model, effects);
    const BaseModes bare = model->base_modes(state);
    const BaseModes full = model->full_modes(state);
    ASSERT_EQ(full.omega.size(), bare.omega.size() + 1);
    ASSERT_EQ(full.own.rows(), 1);
    const Eigen::VectorXd b =
        bare.phi.transpose() * model->row(33, 3).transpose();
    const double own = std::pow(two_pi * hz, 2);
    for (Index m = 0; m < 8; ++m) {
      const double w2 = full.omega(m) * full.omega(m);
      const Eigen::VectorXd q = bare.phi.partialPivLu().solve(full.phi.col(m));
      const double z = -mass * w2 * own / (own - w2);
      const Eigen::VectorXd elastic =
          (bare.omega.array().square() - w2).matrix().asDiagonal() * q;
      EXPECT_LT((elastic + z * b * b.dot(q)).norm(), 1e-9 * w2 * q.norm());
      const double follows = own / (own - w2);
      EXPECT_NEAR(full.own(0, m),
                  follows * b.dot(q),
                  1e-9 * std::abs(follows) * b.norm() * q.norm());
    }
  }
}

}  // namespace
}  // namespace tapfit::updating
