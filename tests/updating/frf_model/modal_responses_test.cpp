#include "tests/updating/support/modal_bundle.hpp"
#include "updating/catalogue/catalogue.hpp"
#include "updating/fit/fit_ground.hpp"
#include "updating/measurement/test_model.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

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
    effects::Setting setting;
    setting.bundle = &test_->bundle();
    setting.deck = &deck_;
    setting.mass_kg = solved_->builder.mass_kg();
    setting.low_hz = test_->band()[0];
    setting.high_hz = test_->band()[1];
    setting.component = measured_component(test_->bundle(), deck_);
    setting.components = tested_components(test_->bundle(), deck_);
    ground_.emplace(
        prepare_fits(*solved_, {setting, *test_, test_->modes({})}, {}));
  }

  [[nodiscard]] const Fitter& fitter() const { return *ground_->fitter; }

  static PlacedEffect at_grid(const std::string& name, int node, double size) {
    PlacedEffect placed{&effects::find(name), {}, {size}};
    placed.where.node = node;
    return placed;
  }

  tapfit::testing::TemporaryFolder folder_;
  std::optional<Measurement> test_;
  structure::Deck deck_;
  std::optional<SolvedModel> solved_;
  std::optional<FitGround> ground_;
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
  std::vector<PlacedEffect> effects = {
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
    const std::vector<PlacedEffect> with = {at_grid("added-mass", node, mass)};
    ModelState loaded = state;
    loaded.effects = with;
    const MatrixXcd exact = model->respond(loaded, s, false).H - before;
    // What modes as close as 10 % do to each other is damped by 2 %, and the
    // larger mass is half a percent of the plate's, beyond the first order.
    EXPECT_LT((change - exact).norm(), close * exact.norm()) << mass;
  }
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
