#include "updating/prediction/predicted_frfs.hpp"

#include "tests/updating/support/plate_model.hpp"

namespace tapfit::updating {
namespace {

using Eigen::Index;
using Eigen::MatrixXcd;
using Eigen::MatrixXd;
using Eigen::VectorXd;

class PredictedFrfs : public PlateModel {
 protected:
  PredictedFrfs() { target_.weight.setConstant(s_.size(), 3.0); }

  /// The plate before and after 50 g are put on it.
  [[nodiscard]] ChangedModel with_mass() const {
    const EffectInstance stated = at_node("added-mass", 30, 0.05);
    const auto model = fitter_->model_for({stated});
    return {model, model, fitter_->first_state(*model, {}), {stated}};
  }

  /// d H / d theta_k of the changed plate by differences.
  [[nodiscard]] std::vector<MatrixXcd> slopes(const ChangedModel& model) const {
    constexpr double step = 1e-4;
    const VectorXd theta = pack(model.state);
    std::vector<MatrixXcd> result;
    for (Index k = 0; k < theta.size(); ++k) {
      const auto at = [&](double by) {
        VectorXd moved = theta;
        moved(k) += by;
        return model.after->respond(model.changed(moved), s_, false).H;
      };
      result.push_back((at(step) - at(-step)) / (2.0 * step));
    }
    return result;
  }

  Target target_ = fitter_->target();
};

TEST_F(PredictedFrfs, AreThoseOfTheChangedModelOnItsOwnLines) {
  const ChangedModel model = with_mass();
  const signal::FrfSet set = predicted_frfs(model, pairs_);
  ASSERT_EQ(set.frfs.size(), pairs_.frfs.size());
  const MatrixXcd H = model.after->respond(model.changed(), s_, false).H;
  const MatrixXcd now = model.now->respond(model.state, s_, false).H;
  EXPECT_GT(difference(H, now), 0.05);
  const std::vector<FrfChange> changes =
      frf_changes(model, target_, MatrixXd::Zero(0, 0), 0.0);
  for (std::size_t f = 0; f < set.frfs.size(); ++f) {
    const auto column = static_cast<Index>(f);
    EXPECT_EQ(set.frfs[f].H, H.col(column));
    EXPECT_EQ(set.frfs[f].response, pairs_.frfs[f].response);
    EXPECT_EQ(set.frfs[f].coherence.minCoeff(), 1.0);
    // Root mean square in units of the level, 3.
    const double change = (H - now).col(column).norm() /
                          std::sqrt(static_cast<double>(s_.size())) / 3.0;
    EXPECT_NEAR(changes[f].change, change, 1e-9 * change);
    EXPECT_EQ(changes[f].sd, 0.0);
  }
}

// The definition, sum_jk dH_j* C_jk dH_k, with slopes by differences.
TEST_F(PredictedFrfs, SpreadAsTheirParametersDo) {
  const ChangedModel model = with_mass();
  const Index n = model.state.parameters();
  // Standard deviations of 1 %, 2 %, ... and correlations of 0.3.
  const VectorXd sd = VectorXd::LinSpaced(n, 0.01, 0.01 * double(n));
  MatrixXd C = 0.3 * sd * sd.transpose();
  C.diagonal() = sd.cwiseAbs2();
  const std::vector<MatrixXcd> d = slopes(model);
  const std::vector<FrfChange> changes = frf_changes(model, target_, C, 0.0);
  for (std::size_t f = 0; f < changes.size(); ++f) {
    double variance = 0.0;
    for (std::size_t j = 0; j < d.size(); ++j) {
      for (std::size_t k = 0; k < d.size(); ++k) {
        const auto column = static_cast<Index>(f);
        variance += C(static_cast<Index>(j), static_cast<Index>(k)) *
                    d[j].col(column).dot(d[k].col(column)).real();
      }
    }
    variance /= 9.0 * static_cast<double>(s_.size());
    // Differences of 1e-4 in a logarithm, damping of a percent: 1e-4.
    EXPECT_NEAR(changes[f].sd / std::sqrt(variance), 1.0, 1e-3) << f;
  }
}

TEST_F(PredictedFrfs, SpreadByTheFormInProportion) {
  const ChangedModel model = with_mass();
  const MatrixXd none = MatrixXd::Zero(0, 0);
  const auto once = frf_changes(model, target_, none, 1e-6);
  const auto twice = frf_changes(model, target_, none, 4e-6);
  for (std::size_t f = 0; f < once.size(); ++f) {
    EXPECT_GT(once[f].sd, 0.0);
    EXPECT_NEAR(twice[f].sd / once[f].sd, 2.0, 1e-9);
  }
}

}  // namespace
}  // namespace tapfit::updating
