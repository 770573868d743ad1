#include "updating/frf_model/form_error.hpp"

#include "acquisition/foundation/seeded_random.hpp"

#include <Eigen/Cholesky>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace tapfit::updating {
namespace {

using acquisition::SeededRandom;
using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

constexpr Index samples = 400;
constexpr Index pattern_count = 20;

MatrixXd gaussian(SeededRandom& random, Index n, Index m) {
  return MatrixXd::NullaryExpr(n, m, [&] { return random.normal(); });
}

FormError alike(const MatrixXd& F) { return {F, VectorXd::Zero(F.cols())}; }

// ln p(r) of the whole covariance, sigma^2 / N I + F (tau^2 I + diag(mu^2)) F',
// in as many dimensions as there are data, tau and sigma on fine grids.
double dense_log_likelihood(const FormError& form, const VectorXd& r) {
  const Index n = r.size();
  const auto N = static_cast<double>(n);
  const auto log_density = [&](double tau, double sigma) {
    const VectorXd var = form.mesh_sd.array().square() + tau * tau;
    MatrixXd C = form.F * var.asDiagonal() * form.F.transpose();
    C.diagonal().array() += sigma * sigma / N;
    const Eigen::LLT<MatrixXd> L(C);
    const double volume = 2.0 * L.matrixLLT().diagonal().array().log().sum();
    const double off = std::log(tau / middle_tau) / 1.1;
    // Of unit variance 1 / N a datum: as the estimate counts it.
    return -0.5 * (volume + N * std::log(N) + r.dot(L.solve(r)) + off * off);
  };
  double sum = 0.0;
  constexpr double step = 0.3;
  const double reference = log_density(middle_tau, 0.01);
  for (double tau = 1e-5; tau < 0.2; tau *= std::exp(step)) {
    double most = -1e300;
    for (double sigma = 1e-3; sigma < 1.0; sigma *= 1.01) {
      most = std::max(most, log_density(tau, sigma));
    }
    sum += std::exp(most - reference) * step;
  }
  return reference + std::log(sum);
}

// Patterns that are others again, one that the mesh leaves more of than the
// form, and one of which nothing shows.
TEST(FormError, IsTheLikelihoodOfItsWholeCovariance) {
  constexpr Index few = 24;
  SeededRandom random(4, "form");
  FormError form{gaussian(random, few, 5), VectorXd::Zero(5)};
  form.F.col(2) = 2.0 * form.F.col(0) - form.F.col(1);
  form.F.col(4).setZero();
  form.mesh_sd(1) = 0.03;
  const VectorXd r = form.F * (0.02 * gaussian(random, 5, 1)) +
                     0.01 / std::sqrt(few * 1.0) * gaussian(random, few, 1);
  const FormEstimate found = estimate_form(view(form, r, {}), few, 0.0);
  // The search over sigma ends within 2 % of it.
  EXPECT_NEAR(found.log_likelihood, dense_log_likelihood(form, r), 0.02);
}

// What the mesh is known to leave of a mode is no sign of the form.
TEST(FormError, TakesWhatTheMeshLeavesForTheMesh) {
  SeededRandom random(5, "form");
  FormError form = alike(10.0 / std::sqrt(samples * 1.0) *
                         gaussian(random, samples, pattern_count));
  const VectorXd r =
      form.F * (0.05 * gaussian(random, pattern_count, 1)) +
      0.02 / std::sqrt(samples * 1.0) * gaussian(random, samples, 1);
  const double unknown = estimate_form(view(form, r, {}), samples, 0.0).tau;
  form.mesh_sd.setConstant(0.05);
  const FormEstimate known = estimate_form(view(form, r, {}), samples, 0.0);
  EXPECT_GT(unknown, 0.03);
  EXPECT_LT(known.tau, 0.6 * unknown);
  EXPECT_NEAR(known.left, 0.02, 0.002);
}

struct Drawn {
  FormEstimate found;
  double left = 0.0;
};

// Patterns of the strength that FRFs have: a percent of stiffness is some ten
// percent of error on lines of 3 % damping.
Drawn draw(unsigned seed, double tau, double sigma) {
  SeededRandom random(seed, "form");
  const MatrixXd F = 10.0 / std::sqrt(samples * 1.0) *
                     gaussian(random, samples, pattern_count);
  const VectorXd noise =
      sigma / std::sqrt(samples * 1.0) * gaussian(random, samples, 1);
  const VectorXd r = F * (tau * gaussian(random, pattern_count, 1)) + noise;
  return {estimate_form(view(alike(F), r, {}), samples, 0.0), noise.norm()};
}

TEST(FormError, IsFoundWithWhatIsLeftBeside) {
  double sum = 0.0;
  int held = 0;
  constexpr int tests = 40;
  for (int k = 0; k < tests; ++k) {
    const Drawn d = draw(static_cast<unsigned>(100 + k), 0.01, 0.02);
    // Of 20 patterns a deviation is known to 1 / sqrt(2 x 20) = 16 %, and half
    // a step of the grid comes on top.
    const double off = std::log(d.found.tau / 0.01);
    sum += off;
    if (std::abs(off) < 2.0 * 0.19) ++held;
    EXPECT_NEAR(d.found.sigma / 0.02, 1.0, 0.2);
    // 20 of 400 data are spent on the patterns.
    EXPECT_NEAR(d.found.left / d.left, 1.0, 0.1);
  }
  EXPECT_GE(held, 35);  // of 40 at 95 %; fewer than 35 in one of 300 such runs
  EXPECT_NEAR(sum / tests, 0.0, 0.1);
}

TEST(FormError, IsNextToNothingWhereNoiseExplainsAll) {
  for (unsigned seed = 0; seed < 10; ++seed) {
    // What noise of 2 % may hide: 0.02 / (10 sqrt(400)) of a pattern, and more.
    EXPECT_LT(draw(seed, 0.0, 0.02).found.tau, 5e-4);
  }
}

// A fit to the least residual moves its parameter wherever that takes most of
// the form's error; the likelihood takes it back.
TEST(FormError, SaysWhereAParameterIsLikeliest) {
  double least = 0.0;
  double likeliest = 0.0;
  for (unsigned seed = 0; seed < 20; ++seed) {
    SeededRandom random(200 + seed, "form");
    const double scale = 1.0 / std::sqrt(samples * 1.0);
    const MatrixXd F = 10.0 * scale * gaussian(random, samples, pattern_count);
    // What it does is much like two of the patterns, and something of its own.
    const MatrixXd J =
        F.col(0) + F.col(1) + 5.0 * scale * gaussian(random, samples, 1);
    const VectorXd data = F * (0.01 * gaussian(random, pattern_count, 1)) +
                          0.02 * scale * gaussian(random, samples, 1);
    const double theta =
        -J.col(0).dot(data) / J.col(0).squaredNorm();  // 0 is true
    const VectorXd r = data + J * theta;
    const VectorXd free = VectorXd::Zero(1);
    const FormEstimate found =
        estimate_form(view(alike(F), r, {J, free, free}), samples, 0.0);
    ASSERT_EQ(found.step.size(), 1);
    least += theta * theta;
    likeliest += std::pow(theta + found.step(0), 2);
  }
  // To be known by its own part alone it is off by 0.02 / (5 sqrt(400)) = 2e-4,
  // by the least residual by some 0.01 x sqrt(2) x 10 / 15 = 6e-3.
  EXPECT_LT(std::sqrt(likeliest / 20.0), 1e-3);
  EXPECT_GT(std::sqrt(least / 20.0), 3e-3);
}

// Log likelihood that an effect gains which explains modal stiffnesses that are
// all off by a share.
double gain_of_explaining(double share, double allowance) {
  SeededRandom random(9, "form");
  const MatrixXd F = 10.0 / std::sqrt(samples * 1.0) *
                     gaussian(random, samples, pattern_count);
  const VectorXd noise =
      0.01 / std::sqrt(samples * 1.0) * gaussian(random, samples, 1);
  const VectorXd shifts = VectorXd::Constant(pattern_count, share);
  const FormError form = alike(F);
  const auto log_likelihood = [&](const VectorXd& r) {
    FormView seen = view(form, r, {});
    seen.allowance = allowance;
    return estimate_form(seen, samples, 0.0).log_likelihood_if_usual;
  };
  return log_likelihood(noise) - log_likelihood(noise + F * shifts);
}

// A form that would be five times the usual one: each of 20 patterns costs
// (5^2 - 1) / 2 at the usual tau, or ln 5 and more at its own.
TEST(FormError, CostsMoreThanAnEffectThatExplainsTheSame) {
  EXPECT_GT(gain_of_explaining(5.0 * middle_tau, 1.0), 20.0);
}

// Half the usual form costs (1/2)^2 / 2 a pattern, 2.5 in all, and less than
// very strong evidence (ln 150): what corners and
// clamps do to many modes alike is no evidence of an effect.
TEST(FormError, IsNoEvidenceWhereItIsUsual) {
  EXPECT_LT(gain_of_explaining(0.5 * middle_tau, 1.0), 5.0);
  // Where decks are held to be more exact it is unusual.
  EXPECT_GT(gain_of_explaining(0.5 * middle_tau, 0.1), 20.0);
}

// Where the data leave the form open, more is taken for it the more a careful
// deck is allowed to be wrong by; where they tell it, it is as it was.
TEST(FormError, FollowsItsAllowanceWhereTheDataLeaveItOpen) {
  SeededRandom random(11, "form");
  const MatrixXd F = 10.0 / std::sqrt(samples * 1.0) *
                     gaussian(random, samples, pattern_count);
  const VectorXd noise =
      0.02 / std::sqrt(samples * 1.0) * gaussian(random, samples, 1);
  const auto mean_tau = [&](double sd, double allowance) {
    const VectorXd shifts = VectorXd::Constant(pattern_count, sd);
    const VectorXd r = F * shifts + noise;
    FormView seen = view(alike(F), r, {});
    seen.allowance = allowance;
    return estimate_form(seen, samples, 0.0).mean_tau;
  };
  EXPECT_GT(mean_tau(0.0, 2.0), 1.01 * mean_tau(0.0, 0.5));
  EXPECT_NEAR(mean_tau(0.01, 2.0) / mean_tau(0.01, 0.5), 1.0, 0.1);
}

}  // namespace
}  // namespace tapfit::updating
