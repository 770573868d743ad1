#include "signal/estimate/estimator.hpp"

#include <gtest/gtest.h>

#include <complex>
#include <random>

namespace tapfit::signal {
namespace {

using complex = std::complex<double>;

struct Data {
  Eigen::MatrixXcd force;
  Eigen::MatrixXcd response;
};

const complex truth(3.0, -4.0);

// Y = H F, with noise of unit variance on either.
Data data(Eigen::Index hits, double on_force, double on_response) {
  std::mt19937_64 engine(11);
  std::normal_distribution<double> normal(0.0, std::sqrt(0.5));
  Data d{Eigen::MatrixXcd(1, hits), Eigen::MatrixXcd(1, hits)};
  for (Eigen::Index k = 0; k < hits; ++k) {
    const complex f = std::polar(2.0, normal(engine));
    d.force(0, k) = f + on_force * complex(normal(engine), normal(engine));
    d.response(0, k) =
        truth * f + on_response * complex(normal(engine), normal(engine));
  }
  return d;
}

TEST(Estimator, AllAgreeWithoutNoise) {
  const Data d = data(3, 0.0, 0.0);
  for (const Estimator e : {Estimator::H1, Estimator::H2, Estimator::Hv}) {
    const Estimate result = estimate(cross_powers(d.force, d.response), e);
    EXPECT_LT(std::abs(result.H(0) - truth), 1e-14);
    EXPECT_NEAR(result.coherence(0), 1.0, 1e-14);
  }
}

TEST(Estimator, H1IsUnbiasedWithNoiseOnTheResponse) {
  const Data d = data(40000, 0.0, 5.0);
  // Gff = 4 per hit: sd of H1 is 5 / (2 sqrt(40000)) = 0.0125; four of them.
  EXPECT_LT(
      std::abs(estimate(cross_powers(d.force, d.response), Estimator::H1).H(0) -
               truth),
      0.05);
  // H2 is too large by 1 + 25 / (25 * 4).
  EXPECT_NEAR(
      std::abs(estimate(cross_powers(d.force, d.response), Estimator::H2).H(0)),
      5.0 * 1.25,
      0.1);
}

TEST(Estimator, H2IsUnbiasedWithNoiseOnTheForce) {
  const Data d = data(40000, 1.0, 0.0);
  EXPECT_LT(
      std::abs(estimate(cross_powers(d.force, d.response), Estimator::H2).H(0) -
               truth),
      0.05);
  EXPECT_NEAR(
      std::abs(estimate(cross_powers(d.force, d.response), Estimator::H1).H(0)),
      5.0 / 1.25,
      0.1);
}

TEST(Estimator, HvIsUnbiasedWithTheSameNoiseRatioOnBoth) {
  const Data d = data(40000, 1.0, 5.0);
  EXPECT_LT(
      std::abs(estimate(cross_powers(d.force, d.response), Estimator::Hv).H(0) -
               truth),
      0.06);
}

TEST(Estimator, CoherenceIsTheShareThatForceExplains) {
  const Data d = data(40000, 0.0, 5.0);
  // |H|^2 Gff / (|H|^2 Gff + N) = 100 / 125; sd about 0.002.
  EXPECT_NEAR(
      estimate(cross_powers(d.force, d.response), Estimator::H1).coherence(0),
      0.8,
      0.01);
}

TEST(Estimator, ASingleHitSaysNothingOfCoherence) {
  const Data d = data(1, 0.0, 5.0);
  EXPECT_EQ(
      estimate(cross_powers(d.force, d.response), Estimator::H1).coherence(0),
      1.0);
}

TEST(Estimator, SumsOfPartsAreTheSumsOfAll) {
  const Data d = data(7, 1.0, 5.0);
  CrossPowers parts;
  parts += cross_powers(d.force.leftCols(3), d.response.leftCols(3));
  parts += cross_powers(d.force.rightCols(4), d.response.rightCols(4));
  const CrossPowers all = cross_powers(d.force, d.response);
  EXPECT_EQ(parts.hits, 7);
  EXPECT_NEAR(parts.Gff(0), all.Gff(0), 1e-13 * all.Gff(0));
  EXPECT_NEAR(parts.Gyy(0), all.Gyy(0), 1e-13 * all.Gyy(0));
  EXPECT_LT(std::abs(parts.Gyf(0) - all.Gyf(0)), 1e-13 * std::abs(all.Gyf(0)));
}

TEST(Estimator, NothingMeasuredGivesNoNaN) {
  const Eigen::MatrixXcd zero = Eigen::MatrixXcd::Zero(2, 3);
  for (const Estimator e : {Estimator::H1, Estimator::H2, Estimator::Hv}) {
    const Estimate result = estimate(cross_powers(zero, zero), e);
    EXPECT_TRUE(result.H.isZero());
    EXPECT_TRUE(result.coherence.isZero());
  }
}

}  // namespace
}  // namespace tapfit::signal
