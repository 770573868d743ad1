#include "tests/updating/support/modal_bundle.hpp"
#include "updating/catalogue/catalogue.hpp"
#include "updating/fit/fit_context.hpp"
#include "updating/measurement/test_model.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <complex>
#include <utility>
#include <vector>

namespace tapfit::updating {
namespace {

using Eigen::Index;
using Eigen::MatrixXcd;
using Eigen::MatrixXd;

/// The plate as it is, its first eight modes measured.
class ModalResponses : public ::testing::Test {
 protected:
  ModalResponses() {
    const std::string text = testing::plate_text({});
    const std::vector<Dof> points = testing::plate_points();
    testing::write_modal_bundle(
        folder_,
        text,
        testing::true_modes(text, points, 8),
        points,
        {},
        R"(, "uncertain": [{"material": 1, "property": "E"},
                           {"material": 1, "property": "rho"}])");
    test_.emplace(folder_.path(), acquisition::Unreadable::Refused);
    deck_ = read_test_model(test_->bundle());
    (void)test_->modes({});
    solved_.emplace(solve_model(deck_, test_->bundle(), test_->band()[1], {}));
    effects::TestContext context;
    context.bundle = &test_->bundle();
    context.deck = &deck_;
    context.mass_kg = solved_->builder.mass_kg();
    context.low_hz = test_->band()[0];
    context.high_hz = test_->band()[1];
    context.component = measured_component(test_->bundle(), deck_);
    context.components = tested_components(test_->bundle(), deck_);
    ground_.emplace(prepare_fits(
        *solved_, {context, *test_, test_->frfs({}), test_->modes({})}, {}));
  }

  [[nodiscard]] const Fitter& fitter() const { return *ground_->fitter; }

  static EffectInstance at_grid(const std::string& name,
                                int node,
                                double size) {
    EffectInstance placed{&effects::find(name), {}, {size}};
    placed.where.node = node;
    return placed;
  }

  tapfit::testing::TemporaryFolder folder_;
  std::optional<Measurement> test_;
  structure::Deck deck_;
  std::optional<SolvedModel> solved_;
  std::optional<FitContext> ground_;
};

TEST_F(ModalResponses, AreThoseMeasuredWithoutScatter) {
  // The deck's own modes, but for the scatter of 0.1 and 2 %, which the error
  // is in units of: three standard deviations of the mean of 128 squares.
  EXPECT_NEAR(ground_->base.result.error,
              ground_->floor_noise,
              0.2 * ground_->floor_noise);
  EXPECT_NEAR(ground_->floor_noise, 1e-3, 1e-4);
}

TEST_F(ModalResponses, DerivativesAreThoseOfDifferences) {
  std::vector<EffectInstance> effects = {
      at_grid("added-mass", testing::plate_grid(8, 1), 0.02),
      at_grid("ground-spring", testing::plate_grid(10, 4), 300.0)};
  const effects::Effect& loss = effects::find("stiffness-loss");
  effects.push_back({&loss, fitter().places(loss).front(), {0.6}});
  const effects::Effect& clamp = effects::find("soft-support");
  effects.push_back({&clamp, fitter().places(clamp).front(), {}});
  const auto model = fitter().model_for(effects);
  for (const effects::ParameterSpec& spec :
       parameters_of(effects.back(), *model)) {
    effects.back().p.push_back(0.1 * spec.start);
  }
  const ModelState state = fitter().first_state(*model, effects);
  const Eigen::VectorXcd& s = fitter().target().s;
  const ModelResponse at = model->respond(state, s, true);
  const Eigen::VectorXd theta = pack(state);
  ASSERT_EQ(at.dH.size(), static_cast<std::size_t>(theta.size()));
  constexpr double h = 1e-4;
  for (Index k = 0; k < theta.size(); ++k) {
    Eigen::VectorXd up = theta;
    Eigen::VectorXd down = theta;
    up(k) += h;
    down(k) -= h;
    const MatrixXcd slope = (model->respond(unpack(state, up), s, false).H -
                             model->respond(unpack(state, down), s, false).H) /
                            (2.0 * h);
    const MatrixXcd& own = at.dH[static_cast<std::size_t>(k)];
    // The differences are good to h^2 and to rounding over h, some 1e-10 of
    // values of some hundred.
    EXPECT_LT((slope - own).norm(), 1e-4 * own.norm() + 1e-6) << k;
  }
}

TEST_F(ModalResponses, PlacesAreFeltAsAMassThereIs) {
  const auto model = fitter().model_for({}, BaseUse::Scan);
  const ModelState state = fitter().first_state(*model, {});
  const Eigen::VectorXcd& s = fitter().target().s;
  const int node = testing::plate_grid(7, 4);
  const MatrixXd row = model->row(node, 3);
  const auto walks = model->walk_columns(state, s, row.transpose());
  ASSERT_EQ(walks.size(), 1U);
  const auto& walk = walks.front();
  ASSERT_EQ(walk.Xo.size(), static_cast<std::size_t>(s.size()));
  const MatrixXcd before = model->respond(state, s, false).H;
  for (const auto& [mass, close] : {std::pair{1e-5, 0.05}, {5e-3, 0.3}}) {
    MatrixXcd change = MatrixXcd::Zero(before.rows(), before.cols());
    for (Index l = 0; l < s.size(); ++l) {
      const std::complex<double> z = s(l) * s(l) * mass;
      const std::complex<double> w =
          -z / (1.0 + walk.own(l, 0) * z) * s(l) * s(l);
      const auto at = static_cast<std::size_t>(l);
      const MatrixXcd o = row * walk.Xo[at];
      const MatrixXcd i = row * walk.Xi[at];
      for (const WalkedPair& pair : walk.pairs) {
        change(l, pair.frf) = w * o(0, pair.response) * i(0, pair.reference);
      }
    }
    const std::vector<EffectInstance> with = {
        at_grid("added-mass", node, mass)};
    ModelState loaded = state;
    loaded.effects = with;
    const MatrixXcd exact = model->respond(loaded, s, false).H - before;
    // What modes as close as 10 % do to each other is damped by 2 %, and the
    // larger mass is half a percent of the plate's, beyond the first order.
    EXPECT_LT((change - exact).norm(), close * exact.norm()) << mass;
  }
}

// Near the clamp the first mode gives hardly more than all others together:
// a spring there bends those, too.
TEST_F(ModalResponses, OtherModesYieldToASpring) {
  const auto model = fitter().model_for({}, BaseUse::Scan);
  const ModelState state = fitter().first_state(*model, {});
  const Eigen::VectorXcd& s = fitter().target().s;
  const int node = testing::plate_grid(2, 2);
  const MatrixXd row = model->row(node, 3);
  const auto walks = model->walk_columns(state, s, row.transpose());
  ASSERT_EQ(walks.size(), 1U);
  const double own = walks[0].own(0, 0).real();
  ASSERT_GT(own, 0.0);
  const double k = 0.2 / own;
  const MatrixXcd o = row * walks[0].Xo[0];
  const MatrixXcd i = row * walks[0].Xi[0];
  const double foreseen =
      (-k / (1.0 + k * own) * s(0) * s(0) * o(0, 0) * i(0, 0)).real();
  ModelState held = state;
  held.effects = {at_grid("ground-spring", node, k)};
  const double exact = (model->respond(held, s, false).H -
                        model->respond(state, s, false).H)(0, 0)
                           .real();
  ASSERT_GT(exact, 0.0);
  // The logarithm's curve takes up to 8 %; without the others' yielding it
  // would be 20 % more.
  EXPECT_NEAR(foreseen / exact, 1.0, 0.15);
}

// A modal stiffness that is off by omega_i omega_j e_ij, symmetric, by
// differences: one e_ij moves both of its modes.
TEST_F(ModalResponses, FormPatternsAreThoseOfDifferences) {
  const auto model = fitter().model_for({});
  const ModelState state = fitter().first_state(*model, {});
  const Eigen::VectorXcd& s = fitter().target().s;
  const std::vector<MatrixXcd> patterns = model->form_patterns(state, s).dH;
  const Eigen::VectorXd omega = model->base_modes(state).omega;
  constexpr double h = 1e-4;
  const auto response = [&](Index i, Index j, double e) {
    ReducedBase base = model->base();
    const double off = i == j ? e : e * M_SQRT1_2;
    base.K(i, j) += off * omega(i) * omega(j);
    if (i != j) base.K(j, i) = base.K(i, j);
    FrfModel changed(std::move(base),
                     model->context(),
                     fitter().problem().measured,
                     fitter().problem().modes);
    changed.set_reference(state);
    return changed.respond(state, s, false).H;
  };
  int crossed = 0;
  for (Index i = 0; i < 8; ++i) {
    for (Index j = i; j < 8; ++j) {
      const MatrixXcd slope =
          (response(i, j, h) - response(i, j, -h)) / (2.0 * h);
      // Modes across each other leave the points where they are.
      if (slope.norm() == 0.0) continue;
      double nearest = 1e300;
      for (const MatrixXcd& pattern : patterns) {
        nearest = std::min({nearest,
                            (pattern - slope).norm() / slope.norm(),
                            (pattern + slope).norm() / slope.norm()});
      }
      // Of modes 10 % apart the guard against close ones takes 1 %.
      constexpr double same = 0.03;
      if (i == j) {
        EXPECT_LT(nearest, same) << i;
      } else if (nearest < same) {
        ++crossed;  // farther ones have no pattern
      }
    }
  }
  EXPECT_GE(crossed, 12);
  // Eight modes, each with itself, with five neighbours at most; two in common.
  EXPECT_LE(patterns.size(), 8U + 8U * 5U + 2U);
}

TEST(ModalData, HandPairsStandWhateverTheShapes) {
  ModalData data;
  data.frequency_hz = Eigen::Vector2d(10.0, 20.0);
  data.shape.resize(0, 2);
  data.shape_weight.resize(0, 2);
  const Eigen::Vector3d omega = 2.0 * M_PI * Eigen::Vector3d(9.9, 20.1, 40.0);
  const MatrixXd none(0, 3);
  const auto plain = paired_modes(data, omega, none);
  EXPECT_EQ(plain[0].model, 0);
  EXPECT_EQ(plain[1].model, 1);
  const auto by_hand = paired_modes(data, omega, none, {{0, 2}});
  EXPECT_EQ(by_hand[0].model, 2);
  EXPECT_EQ(by_hand[1].model, 1);
}

// All points at the nodes of a mode: no weight on its shape, and the partner
// that is next in frequency.
TEST(ModalData, OfAShapeOfNothingTheFrequencyCounts) {
  modal::ModeSet set;
  set.dofs = {{1, 3, 1}, {2, 3, 1}};
  for (const double hz : {10.0, 20.0}) {
    modal::Mode mode;
    mode.frequency_hz = hz;
    mode.frequency_sd_hz = 0.01 * hz;
    mode.shape = Eigen::Vector2cd(1.0, 2.0);
    mode.shape_sd = Eigen::Vector2d::Ones();
    set.modes.push_back(mode);
  }
  set.modes[0].shape.setZero();
  const ModalData data = modal_data(set);
  EXPECT_TRUE(data.shape.col(0).isZero(0.0));
  EXPECT_TRUE(data.shape_weight.col(0).isZero(0.0));
  const Eigen::Vector3d omega = 2.0 * M_PI * Eigen::Vector3d(9.9, 20.1, 40.0);
  MatrixXd at(2, 3);
  at << 1.0, 1.0, 2.0, -1.0, 2.0, 1.0;
  EXPECT_EQ(paired_modes(data, omega, at)[0].model, 0);
  EXPECT_EQ(paired_modes(data, omega, at)[1].model, 1);
  EXPECT_TRUE(foreign_modes(data, omega, at).empty());
}

TEST(ModalData, WeighsEachByItsOwnStandardDeviation) {
  modal::ModeSet set;
  set.dofs = {{1, 3, 1}, {2, 3, 1}};
  for (const double sd : {0.01, 0.07}) {
    modal::Mode mode;
    mode.frequency_hz = 10.0;
    mode.frequency_sd_hz = sd;
    // Of length 5, turned by an angle that says nothing.
    mode.shape = std::polar(1.0, 0.5) * Eigen::Vector2cd(3.0, -4.0);
    mode.shape_sd = Eigen::Vector2d(0.5, 0.25);
    set.modes.push_back(mode);
  }
  const ModalData data = modal_data(set);
  EXPECT_NEAR(data.sd, 0.005, 1e-12);  // root mean square of 0.1 and 0.7 %
  EXPECT_NEAR(data.frequency_weight(0), 5.0, 1e-9);
  EXPECT_NEAR(data.frequency_weight(1), 5.0 / 7.0, 1e-9);
  EXPECT_NEAR(std::abs(data.shape(0, 0)), 0.6, 1e-9);
  EXPECT_NEAR(data.shape(0, 0) * data.shape(1, 0), -0.48, 1e-9);
  EXPECT_NEAR(data.shape_weight(0, 0), 0.005 / 0.1, 1e-9);
  EXPECT_NEAR(data.shape_weight(1, 1), 0.005 / 0.05, 1e-9);
  const ModalData second = data.only({1});
  ASSERT_EQ(second.modes(), 1);
  EXPECT_EQ(second.sd, data.sd);
  EXPECT_EQ(second.frequency_weight(0), data.frequency_weight(1));
}

TEST(ModalData, LeavingOutKeepsPairsByHandWithTheirModes) {
  ModalData data;
  data.frequency_hz = data.frequency_weight = Eigen::Vector3d(10.0, 20.0, 30.0);
  data.shape.resize(0, 3);
  data.shape_weight.resize(0, 3);
  data.fixed = {{0, 4}, {2, 7}};
  const ModalData part = data.only({1, 2});
  ASSERT_EQ(part.fixed.size(), 1U);
  EXPECT_EQ(part.fixed[0], (std::pair<Index, Index>{1, 7}));
}

TEST(ModalData, TheFactorThatFitsBestIsFoundAndItsSlopeToo) {
  ModalData data;
  data.frequency_hz = Eigen::VectorXd::Constant(1, 10.0);
  data.dofs = {{1, 3, 1}, {2, 3, 1}, {3, 3, 1}};
  const Eigen::Vector3d e(0.6, -0.64, 0.48);
  const Eigen::Vector3d q(1.0, 2.0, 0.5);
  data.shape = e;
  data.shape_weight = q;
  const Eigen::Vector3d u(-1.0, 1.2, -0.4);
  const Eigen::VectorXd omega = Eigen::VectorXd::Constant(1, 20.0 * M_PI);
  const auto fitted = [&](const Eigen::Vector3d& shape) -> Eigen::Vector3d {
    return paired_modes(data, omega, shape)[0].factor * shape;
  };
  // Normal equation: what is left is across u, weighted.
  const Eigen::Vector3d left = q.cwiseProduct(e - fitted(u));
  EXPECT_NEAR(left.dot(q.cwiseProduct(u)), 0.0, 1e-12);
  const Eigen::Vector3d du(0.3, 0.1, -0.2);
  constexpr double h = 1e-6;
  const Eigen::Vector3d slope =
      (fitted(u + h * du) - fitted(u - h * du)) / (2.0 * h);
  const Eigen::MatrixXd own =
      paired_modes(data, omega, u)[0].fitted_change(e, q, du);
  EXPECT_LT((own - slope).norm(), 1e-8);
}

TEST(ModalData, ShapesLikeNoneOfTheModelsAreForeign) {
  ModalData data;
  data.frequency_hz = Eigen::Vector2d(10.0, 20.0);
  data.dofs = {{1, 3, 1}, {2, 3, 1}, {3, 3, 1}};
  data.shape = MatrixXd::Identity(3, 2);
  data.shape_weight = MatrixXd::Ones(3, 2);
  MatrixXd model = MatrixXd::Zero(3, 2);
  model(0, 0) = 2.0;   // the first, of another scale
  model(2, 1) = -1.0;  // and one that the test has not
  const Eigen::Vector2d omega = 2.0 * M_PI * Eigen::Vector2d(11.0, 19.0);
  EXPECT_EQ(foreign_modes(data, omega, model), std::vector<Index>{1});
  data.fixed = {{1, 1}};
  EXPECT_TRUE(foreign_modes(data, omega, model).empty());
}

}  // namespace
}  // namespace tapfit::updating
