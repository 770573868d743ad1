#include "updating/damping_statement.hpp"

#include "tests/updating/support/sample_plate.hpp"
#include "updating/effects/catalogue.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace tapfit::updating {
namespace {

using Eigen::Index;

/// The sample plate's FRFs with ratios of damping as given, noise of 1 %, and
/// the plate's model fitted to them.
class Damped : public testing::Test {
 protected:
  [[nodiscard]] std::optional<std::string> statement(
      const std::function<double(Index, double)>& zeta) {
    Eigen::VectorXcd s(120);
    for (Index l = 0; l < s.size(); ++l) {
      const double w = 2.0 * M_PI * (20.0 + 10.0 * static_cast<double>(l));
      s(l) = {0.03 * w, w};
    }
    FitSetting setting;
    setting.setting = support::plate_setting(bundle_, deck_);
    setting.setting.high_hz = options_.high_hz;
    setting.measured = support::plate_pairs(bundle_, s);
    setting.targets = {make_target(setting.measured)};
    const Fitter blank(builder_, setting);
    const auto model = blank.model_for({});
    ModelState truth = blank.first_state(*model, {});
    const Eigen::VectorXd omega = model->base_modes(truth).omega;
    truth.zeta.resize(omega.size());
    for (Index m = 0; m < omega.size(); ++m) {
      truth.zeta(m) = zeta(m, omega(m));
    }
    Eigen::MatrixXcd H = model->respond(truth, s, false).H;
    std::srand(5);
    H.array() *= 1.0 + 0.01 * Eigen::ArrayXXcd::Random(H.rows(), H.cols());
    for (Index f = 0; f < H.cols(); ++f) {
      signal::Frf& frf = setting.measured.frfs[static_cast<std::size_t>(f)];
      frf.H = H.col(f);
      frf.variance = (0.01 * H.col(f).cwiseAbs()).cwiseAbs2();
    }
    setting.targets = {make_target(setting.measured)};
    const Fitter fitter(builder_, std::move(setting));
    const Fit fit = fitter.fit({}, fitter.model_for({}));
    return damping_statement(
        fit, fitter, effective_data(fitter.target()), Progress{});
  }

  structure::Deck deck_ = support::plate_deck(true);
  acquisition::TestBundle bundle_ = support::plate_bundle();
  BaseOptions options_ = [this] {
    BaseOptions options = support::plate_base(bundle_, deck_);
    options.high_hz = 1200.0;  // eight modes
    return options;
  }();
  BaseBuilder builder_{deck_, {}, options_, Progress{}};
};

TEST_F(Damped, RayleighDampingIsCalledALaw) {
  const auto said =
      statement([](Index, double w) { return 0.5 * (6.0 / w + 1.2e-5 * w); });
  ASSERT_TRUE(said.has_value());
  EXPECT_NE(said->find("viscous_beta 1.2e-05"), std::string::npos) << *said;
}

TEST_F(Damped, RatiosThatJumpFollowNoLaw) {
  EXPECT_FALSE(statement([](Index m, double) {
                 return m % 2 == 0 ? 0.005 : 0.03;
               }).has_value());
}

}  // namespace
}  // namespace tapfit::updating
