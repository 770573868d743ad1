#include "updating/localisation/projected_misfit.hpp"

#include "tests/updating/support/sample_plate.hpp"
#include "updating/catalogue/catalogue.hpp"
#include "updating/residual/independent_data.hpp"

#include <Eigen/QR>
#include <gtest/gtest.h>

namespace tapfit::updating {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

/// The sample plate without a mass, fitted to its FRFs with it.
class Projected : public testing::Test, private support::BasedPlate {
 protected:
  // @param sd of ln E, as known before
  void fit_with(double sd) {
    Eigen::VectorXcd s(60);
    for (Index l = 0; l < s.size(); ++l) {
      const double w = 2.0 * M_PI * (20.0 + 6.0 * static_cast<double>(l));
      s(l) = {0.03 * w, w};
    }
    FitProblem problem;
    problem.context = context_;
    problem.measured = support::plate_pairs(bundle_, s);
    problem.uncertain_sd = {sd};
    problem.targets = {make_target(problem.measured)};
    const Fitter blank(builder_, problem);
    EffectInstance mass{&effects::find("added-mass"), {}, {0.02}};
    mass.where.node = 33;
    const auto truth = blank.model_for({mass});
    const Eigen::MatrixXcd H =
        truth->respond(blank.first_state(*truth, {mass}), s, false).H;
    for (Index f = 0; f < H.cols(); ++f) {
      signal::Frf& frf = problem.measured.frfs[static_cast<std::size_t>(f)];
      frf.H = H.col(f);
      frf.variance = (0.01 * H.col(f).cwiseAbs()).cwiseAbs2();
    }
    problem.targets = {make_target(problem.measured)};
    problem.targets.back().modes_in_band = 5;
    fitter_.emplace(builder_, std::move(problem));
    fit_ = fitter_->fit({}, fitter_->model_for({}));
  }

  // What half as stiff a plate would change, to first order.
  [[nodiscard]] Eigen::MatrixXcd softer() const {
    return -0.5 *
           fit_.model->respond(fit_.result.state, fitter_->target().s, true)
               .dH[0];
  }

  std::optional<Fitter> fitter_;
  Fit fit_;
};

// min over x of ||m + c + J x||^2 + u^2 sum ((theta + x - mean) / sd)^2,
// u the residual's deviation.
TEST_F(Projected, WhatReadjustsKeepsToThePrior) {
  for (const double sd : {0.003, 0.03, 0.3}) {
    fit_with(sd);
    const Target& target = fitter_->target();
    const ProjectedMisfit misfit(fit_, target);
    const ModelResponse now =
        fit_.model->respond(fit_.result.state, target.s, true);
    const VectorXd m = stack(target, now.H - target.H);
    const VectorXd c = misfit.change(softer());
    const Prior& prior = fit_.result.prior;
    const VectorXd weight =
        m.norm() / std::sqrt(effective_data(target)) * prior.sd.cwiseInverse();
    const auto n = static_cast<Index>(now.dH.size());
    MatrixXd J(m.size() + n, n);
    for (Index k = 0; k < n; ++k) {
      J.col(k).head(m.size()) =
          stack(target, now.dH[static_cast<std::size_t>(k)]);
    }
    J.bottomRows(n) = weight.asDiagonal();
    VectorXd r(J.rows());
    r.head(m.size()) = m + c;
    r.tail(n) = weight.cwiseProduct(pack(fit_.result.state) - prior.mean);
    const VectorXd x = J.completeOrthogonalDecomposition().solve(r);
    EXPECT_NEAR(misfit.errors(c)(0), (r - J * x).norm(), 1e-9) << sd;
  }
}

TEST_F(Projected, AModulusThatIsKnownDoesNotMakeUpForWhatIsMissing) {
  fit_with(0.3);
  const ProjectedMisfit unknown(fit_, fitter_->target());
  EXPECT_LT(unknown.errors(unknown.change(softer()))(0),
            1.2 * unknown.unchanged());
  fit_with(0.003);
  const ProjectedMisfit known(fit_, fitter_->target());
  EXPECT_GT(known.errors(known.change(softer()))(0), 2.0 * known.unchanged());
}

}  // namespace
}  // namespace tapfit::updating
