#include "updating/minimiser/minimise.hpp"

#include <Eigen/Cholesky>
#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace tapfit::updating {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

constexpr double infinite = std::numeric_limits<double>::infinity();

Prior no_prior(Index n) {
  return {VectorXd::Zero(n),
          VectorXd::Constant(n, infinite),
          VectorXd::Constant(n, -infinite),
          VectorXd::Constant(n, infinite)};
}

CountData data(double count) {
  return [count](const VectorXd&) { return count; };
}

// Rosenbrock's valley, with something left at its end.
std::optional<Residuals> valley(const VectorXd& t) {
  Residuals at{VectorXd(3), MatrixXd(3, 2)};
  at.r << 10.0 * (t(1) - t(0) * t(0)), 1.0 - t(0), 0.1;
  at.J << -20.0 * t(0), 10.0, -1.0, 0.0, 0.0, 0.0;
  return at;
}

// A sum of exponentials that no rate fits: much is left, and r'' r is as large
// as J'J.
std::optional<Residuals> misfit(const VectorXd& t) {
  constexpr Index n = 40;
  Residuals at{VectorXd(n), MatrixXd(n, 2)};
  for (Index i = 0; i < n; ++i) {
    const double x = 0.1 * static_cast<double>(i);
    const double e = std::exp(-std::exp(t(0)) * x);
    const double c = std::cos(std::exp(t(1)) * x);
    const double measured =
        std::exp(-x) * std::cos(3.0 * x) + 0.8 * std::cos(4.5 * x + 1.0);
    at.r(i) = e * c - measured;
    at.J(i, 0) = -x * std::exp(t(0)) * e * c;
    at.J(i, 1) = -x * std::exp(t(1)) * e * std::sin(std::exp(t(1)) * x);
  }
  return at;
}

TEST(Minimise, FollowsAValleyToItsEnd) {
  VectorXd start(2);
  start << -1.2, 1.0;
  const auto found =
      minimise(valley, no_prior(2), data(100.0), start, {200, 1e-10, 0.0});
  ASSERT_TRUE(found);
  EXPECT_TRUE(found->converged) << found->message;
  EXPECT_NEAR(found->point.theta(0), 1.0, 1e-6);
  EXPECT_NEAR(found->point.theta(1), 1.0, 1e-6);
}

// By J'J alone the steps of this one go past the minimum and back: its slope
// must vanish all the same, and soon.
TEST(Minimise, ArrivesWhereMuchIsLeft) {
  VectorXd start(2);
  start << 0.0, std::log(3.6);
  const auto found =
      minimise(misfit, no_prior(2), data(40.0), start, {25, 1e-9, 1e-6});
  ASSERT_TRUE(found);
  EXPECT_TRUE(found->converged) << found->message;
  const Residuals& at = found->point.at;
  const double w = 40.0 / at.r.squaredNorm();
  // f is within its tolerance: a thousandth of a standard deviation.
  const VectorXd g = w * at.J.transpose() * at.r;
  const MatrixXd A = w * at.J.transpose() * at.J;
  EXPECT_LT(g.dot(A.ldlt().solve(g)), 1e-4);
}

TEST(Minimise, NeverRises) {
  VectorXd start(2);
  start << -1.2, 1.0;
  double last = 1e300;
  const auto found = minimise(valley,
                              no_prior(2),
                              data(100.0),
                              start,
                              {50, 1e-10, 0.0},
                              [&](const Iterate& point) {
                                EXPECT_LT(point.objective, last);
                                last = point.objective;
                                return true;
                              });
  ASSERT_TRUE(found);
  EXPECT_EQ(found->point.objective, last);
}

// With a bound across the valley it ends on it, at the least along it.
TEST(Minimise, EndsOnABound) {
  Prior prior = no_prior(2);
  prior.upper(0) = 0.5;
  VectorXd start(2);
  start << -1.2, 1.0;
  const auto found =
      minimise(valley, prior, data(100.0), start, {200, 1e-10, 0.0});
  ASSERT_TRUE(found);
  EXPECT_EQ(found->point.theta(0), 0.5);
  EXPECT_NEAR(found->point.theta(1), 0.25, 1e-7);
}

// N ln r^2 + ((theta - mean) / sd)^2 of r = (theta - 1, 1): its slope is zero
// where N (theta - 1) / r^2 = -theta / sd^2.
TEST(Minimise, WeighsThePrior) {
  const auto line = [](const VectorXd& t) -> std::optional<Residuals> {
    Residuals at{VectorXd(2), MatrixXd(2, 1)};
    at.r << t(0) - 1.0, 1.0;
    at.J << 1.0, 0.0;
    return at;
  };
  Prior prior = no_prior(1);
  prior.sd(0) = 0.5;
  const auto found =
      minimise(line, prior, data(10.0), VectorXd::Zero(1), {100, 1e-12, 0.0});
  ASSERT_TRUE(found);
  const double t = found->point.theta(0);
  EXPECT_NEAR(
      10.0 * (t - 1.0) / ((t - 1.0) * (t - 1.0) + 1.0) + t / 0.25, 0.0, 1e-6);
}

// The same as data besides; what they and the prior say of two parameters adds
// up.
TEST(Minimise, WeighsWhatIsKnownBesides) {
  const auto line = [](const VectorXd& t) -> std::optional<Residuals> {
    Residuals at{VectorXd(2), MatrixXd(2, 1)};
    at.r << t(0) - 1.0, 1.0;
    at.J << 1.0, 0.0;
    return at;
  };
  const auto end = [&line](const Prior& prior) {
    const auto found =
        minimise(line, prior, data(10.0), VectorXd::Zero(1), {100, 1e-12, 0.0});
    return found ? found->point.theta(0) : 1e300;
  };
  const auto known = [](double sd) {
    return [sd](const VectorXd& t) -> Residuals {
      return {t / sd, MatrixXd::Constant(1, 1, 1.0 / sd)};
    };
  };
  Prior prior = no_prior(1);
  prior.sd(0) = 0.5;
  Prior besides = no_prior(1);
  besides.known = known(0.5);
  EXPECT_NEAR(end(besides), end(prior), 1e-9);
  prior.known = known(0.5);
  Prior both = no_prior(1);
  both.sd(0) = 0.5 / std::sqrt(2.0);
  EXPECT_NEAR(end(prior), end(both), 1e-9);
}

TEST(Minimise, StopsWhenTold) {
  int steps = 0;
  const auto found = minimise(valley,
                              no_prior(2),
                              data(100.0),
                              VectorXd::Zero(2),
                              {200, 1e-10, 0.0},
                              [&](const Iterate&) { return ++steps < 3; });
  ASSERT_TRUE(found);
  EXPECT_FALSE(found->converged);
  EXPECT_EQ(steps, 3);
  EXPECT_EQ(found->message, "stopped by hand");
}

// Once nothing lowers f any more the
// box shrinks to its end: by 0.3 from some thousand deviations to 1e-10, 26
// evaluations, and each at most twice.
TEST(Minimise, EndsWhereNoStepLowersIt) {
  int evaluations = 0;
  const auto turning = [&](const VectorXd& t) {
    std::optional<Residuals> at = valley(t);
    if (++evaluations > 6) at->r *= 2.0 + 0.1 * (evaluations % 2);
    return at;
  };
  VectorXd start(2);
  start << -1.2, 1.0;
  const auto found =
      minimise(turning, no_prior(2), data(100.0), start, {200, 1e-10, 0.0});
  ASSERT_TRUE(found);
  EXPECT_LT(evaluations, 80);
}

TEST(Minimise, TellsWhereThereIsNothingAtTheStart) {
  const auto none = [](const VectorXd&) -> std::optional<Residuals> {
    return std::nullopt;
  };
  EXPECT_FALSE(minimise(none, no_prior(1), data(1.0), VectorXd::Zero(1), {}));
}

// A model that has no answer beyond some value is left where it has one.
TEST(Minimise, StepsBackFromWhereThereIsNoAnswer) {
  const auto edge = [](const VectorXd& t) -> std::optional<Residuals> {
    if (t(0) > 0.4) return std::nullopt;
    Residuals at{VectorXd(2), MatrixXd(2, 1)};
    at.r << t(0) - 1.0, 1.0;
    at.J << 1.0, 0.0;
    return at;
  };
  const auto found = minimise(
      edge, no_prior(1), data(10.0), VectorXd::Zero(1), {100, 1e-9, 0.0});
  ASSERT_TRUE(found);
  EXPECT_NEAR(found->point.theta(0), 0.4, 1e-3);
}

}  // namespace
}  // namespace tapfit::updating
