#include "signal/estimate/linearity_check.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <random>

namespace tapfit::signal {
namespace {

using Eigen::Index;
using Eigen::VectorXcd;
using Eigen::VectorXd;

struct Options {
  int runs = 12;
  Index hits = 5;
  double noise = 0.02;      // of the response, relative to its mean
  double scatter = 0.02;    // of each hit's place: sd of a factor
  double stiffening = 0.0;  // of a mode's omega^2, per relative level
};

// Accelerance of two modes, the first of which stiffens with the level.
VectorXcd frf(const VectorXcd& s, double level, double stiffening) {
  VectorXcd H = VectorXcd::Zero(s.size());
  const double w1 = 2.0 * std::numbers::pi * 20.0;
  const double w2 = 2.0 * std::numbers::pi * 55.0;
  const double k = w1 * w1 * (1.0 + stiffening * (level - 1.0));
  for (Index l = 0; l < s.size(); ++l) {
    const std::complex<double> x = s(l);
    H(l) = x * x / (x * x + 0.02 * w1 * x + k) -
           0.6 * x * x / (x * x + 0.016 * w2 * x + w2 * w2);
  }
  return H;
}

LinearityFinding finding_of(const Options& options, unsigned seed) {
  std::mt19937 random(seed);
  std::normal_distribution<double> normal;
  std::uniform_real_distribution<double> uniform(0.6, 1.4);
  VectorXcd s(80);
  s.real().setConstant(4.0);
  s.imag().setLinSpaced(
      80, 2.0 * std::numbers::pi * 5.0, 2.0 * std::numbers::pi * 80.0);
  const VectorXd mean = frf(s, 1.0, 0.0).cwiseAbs();
  LinearityCheck levels;
  for (int run = 0; run < options.runs; ++run) {
    Spectra spectra;
    spectra.force.resize(s.size(), options.hits);
    spectra.responses.assign(2, Eigen::MatrixXcd(s.size(), options.hits));
    for (Index hit = 0; hit < options.hits; ++hit) {
      const double level = uniform(random);
      spectra.force.col(hit).setConstant(level);
      for (Eigen::MatrixXcd& response : spectra.responses) {
        const double place = 1.0 + options.scatter * normal(random);
        response.col(hit) = place * level * frf(s, level, options.stiffening);
        for (Index l = 0; l < s.size(); ++l) {
          response(l, hit) +=
              options.noise * mean.mean() *
              std::complex<double>(normal(random), normal(random));
        }
      }
    }
    levels.add(spectra);
  }
  return levels.finding(1);
}

TEST(LinearityCheck, SuspectsNoLinearStructure) {
  int suspected = 0;
  for (unsigned seed = 1; seed <= 100; ++seed) {
    if (!statement(finding_of({}, seed)).empty()) ++suspected;
  }
  // One of 3,000 by chance; one of 100 has a probability of 3 %.
  EXPECT_EQ(suspected, 0);
}

// The p-value of a linear structure is uniform: 10 % of it lie below 0.1.
TEST(LinearityCheck, ItsPValueIsFair) {
  int below = 0;
  constexpr int tests = 200;
  for (unsigned seed = 1; seed <= tests; ++seed) {
    Options few;
    few.runs = 4;
    few.hits = 4;
    if (finding_of(few, seed).p_value <= 0.1) ++below;
  }
  // Three standard deviations of a binomial.
  EXPECT_NEAR(below, 0.1 * tests, 3.0 * std::sqrt(0.09 * tests));
}

TEST(LinearityCheck, FindsAStiffeningModeAndItsSize) {
  Options options;
  options.noise = options.scatter = 0.005;
  options.stiffening = 0.02;
  const LinearityFinding finding = finding_of(options, 3);
  EXPECT_LE(finding.p_value, 0.0002);
  EXPECT_GT(finding.share, finding.share_by_chance);
  // The same from the two models at the levels' mean range over five hits,
  // 0.8 * (5 - 1) / (5 + 1), lines as above.
  VectorXcd s(80);
  s.real().setConstant(4.0);
  s.imag().setLinSpaced(
      80, 2.0 * std::numbers::pi * 5.0, 2.0 * std::numbers::pi * 80.0);
  const double half = 0.8 * 4.0 / 6.0 / 2.0;
  const VectorXcd change = frf(s, 1.0 + half, 0.02) - frf(s, 1.0 - half, 0.02);
  const double expected = std::sqrt(
      change.cwiseAbs2().cwiseQuotient(frf(s, 1.0, 0.0).cwiseAbs2()).mean());
  // Ranges differ from run to run, and the modes do not move linearly.
  EXPECT_NEAR(finding.change, expected, 0.25 * expected);
  EXPECT_FALSE(statement(finding).empty());
}

TEST(LinearityCheck, SaysNothingOfEvenOrFewHits) {
  Options two;
  two.hits = 2;
  two.stiffening = 0.05;
  EXPECT_EQ(finding_of(two, 1).runs, 0);
  EXPECT_TRUE(statement(LinearityCheck().finding(1)).empty());
}

}  // namespace
}  // namespace tapfit::signal
