#include "signal/checks/frf_checks.hpp"

#include "tests/signal/support/generated_test.hpp"

#include <gtest/gtest.h>

namespace tapfit::signal {
namespace {

using complex = std::complex<double>;
using std::numbers::pi;

FrfSet lines(double low_hz, double high_hz, double sigma) {
  FrfSet set;
  set.s.resize(400);
  set.s.real().setConstant(sigma);
  set.s.imag().setLinSpaced(2.0 * pi * low_hz, 2.0 * pi * high_hz);
  return set;
}

template <class Function>
void add(FrfSet& set, const Dof& response, const Dof& reference, Function H) {
  Frf frf;
  frf.response = response;
  frf.reference = reference;
  frf.hits = 3;
  frf.H = set.s.unaryExpr(H);
  frf.variance = 1e-6 * frf.H.cwiseAbs2();
  frf.coherence = Eigen::VectorXd::Constant(frf.H.size(), 0.98);
  set.frfs.push_back(std::move(frf));
}

const std::vector<TestMode> positive{{20.0, 0.01, 1.0}, {61.0, 0.008, 0.7}};

TEST(DrivingPoint, APassiveOneIsFoundFair) {
  for (const double sigma : {0.0, 3.0}) {
    FrfSet set = lines(5.0, 100.0, sigma);
    add(set, {3, 3, -1}, {3, 3, -1}, [](complex s) {
      return exact_frf(positive, s);
    });
    add(set, {3, 3, 1}, {7, 3, 1}, [](complex s) {
      return -exact_frf(positive, s);
    });
    const std::vector<DrivingPoint> points = driving_points(set);
    ASSERT_EQ(points.size(), 1u) << "the other one is no driving point";
    EXPECT_GE(points[0].peaks, 2);
    EXPECT_EQ(points[0].wrong_peaks, 0);
    EXPECT_EQ(points[0].active_share, 0.0);
    EXPECT_FALSE(points[0].turned());
  }
}

TEST(DrivingPoint, ATurnedSensorShows) {
  FrfSet set = lines(5.0, 100.0, 1.0);
  add(set, {3, 3, 1}, {3, 3, -1}, [](complex s) {
    return exact_frf(positive, s);  // the signs are turned, the values not
  });
  const DrivingPoint point = driving_points(set).at(0);
  EXPECT_TRUE(point.turned());
  EXPECT_GT(point.active_share, 0.9);
}

// A transfer FRF under a driving point's name: its second mode is negative.
TEST(DrivingPoint, AnotherPlaceShows) {
  FrfSet set = lines(5.0, 100.0, 1.0);
  add(set, {3, 3, 1}, {3, 3, 1}, [](complex s) {
    return exact_frf({{20.0, 0.01, 1.0}, {61.0, 0.008, -0.7}}, s);
  });
  const DrivingPoint point = driving_points(set).at(0);
  EXPECT_EQ(point.wrong_peaks, 1);
  EXPECT_GT(point.active_share, 0.1);
}

TEST(DrivingPoint, MassLineAndStiffnessLine) {
  // A free mass of 2 kg with a mode far above; a grounded 8 kN/m likewise.
  FrfSet free = lines(1.0, 10.0, 0.2);
  add(free, {1, 3, 1}, {1, 3, 1}, [](complex s) {
    return 0.5 + exact_frf({{300.0, 0.01, 0.5}}, s);
  });
  const DrivingPoint mass = driving_points(free).at(0);
  EXPECT_EQ(mass.low, LowLine::Mass);
  // s^4 / w^4 at 2 Hz of 300 Hz: what the second term leaves.
  EXPECT_NEAR(mass.mass_kg, 2.0, 2e-8);
  FrfSet held = lines(1.0, 10.0, 0.0);
  add(held, {1, 3, 1}, {1, 3, 1}, [](complex s) {
    const double w = 2.0 * pi * 300.0;
    return s * s / (8000.0 * (1.0 + s * s / (w * w)));
  });
  const DrivingPoint spring = driving_points(held).at(0);
  EXPECT_EQ(spring.low, LowLine::Stiffness);
  EXPECT_NEAR(spring.stiffness_n_per_m, 8000.0, 1e-4);
}

// The first mode at 4 times the lowest line lowers |A| by 33 % at the octave's
// end. The second term takes that up but for x^2, x = (f / f1)^2 from 1/16 to
// 1/4: a line through two points of x^2 meets x = 0 at -x1 x2, about -0.025.
TEST(DrivingPoint, AModeNearbyHardlyMovesTheMassLine) {
  FrfSet set = lines(5.0, 60.0, 0.3);
  add(set, {1, 3, 1}, {1, 3, 1}, [](complex s) {
    return 0.5 + exact_frf({{20.0, 0.01, 0.5}}, s);
  });
  const DrivingPoint point = driving_points(set).at(0);
  EXPECT_EQ(point.low, LowLine::Mass);
  EXPECT_NEAR(point.mass_kg, 2.0, 0.07);
  // Twice as near it is no mass line any more.
  FrfSet near = lines(8.0, 60.0, 0.3);
  add(near, {1, 3, 1}, {1, 3, 1}, [](complex s) {
    return 0.5 + exact_frf({{20.0, 0.01, 0.5}}, s);
  });
  EXPECT_EQ(driving_points(near).at(0).low, LowLine::Neither);
}

// Of what another sensor recorded of the same blows: where it would pass, the
// channels may be swapped.
TEST(DrivingPoint, NamesTheOneThatWouldPass) {
  FrfSet set = lines(5.0, 100.0, 1.0);
  add(set, {3, 3, 1}, {3, 3, 1}, [](complex s) {
    return exact_frf({{20.0, 0.01, 1.0}, {61.0, 0.008, -0.7}}, s);
  });
  EXPECT_FALSE(driving_points(set).at(0).rather);
  add(set, {7, 3, 1}, {3, 3, 1}, [](complex s) {
    return exact_frf(positive, s);
  });
  EXPECT_EQ(driving_points(set).at(0).rather, 1U);
  set.frfs[1].run = 1;  // other blows say nothing
  EXPECT_FALSE(driving_points(set).at(0).rather);
}

TEST(Reciprocity, FairPairsAndAGain) {
  FrfSet set = lines(5.0, 100.0, 1.0);
  const auto H = [](complex s) { return exact_frf(positive, s); };
  add(set, {3, 3, 1}, {7, 3, -1}, H);
  add(set, {7, 3, 1}, {3, 3, 1}, [&](complex s) { return -H(s) / 1.25; });
  const std::vector<Reciprocal> pairs = reciprocals(set);
  ASSERT_EQ(pairs.size(), 1u);
  // Hit the other way, and a sensor that reads a fifth too little.
  EXPECT_NEAR(pairs[0].gain, 1.25, 1e-12);
  EXPECT_NEAR(pairs[0].difference, 0.2 / std::sqrt(0.8), 1e-12);
  EXPECT_LT(pairs[0].shape_difference, 1e-12);
  EXPECT_GT(pairs[0].chi2, 1e4);
  EXPECT_FALSE(pairs[0].fair());
}

// A thousandth of one FRF and all of another: 0.001^-0.5 apart by their
// geometric mean, and still no factor.
TEST(Reciprocity, UnlikeSizesAreNoFactor) {
  Reciprocal pair;
  pair.difference = 31.6;
  pair.gain = 1000.0;
  pair.shape_difference = 0.9;
  EXPECT_FALSE(pair.by_a_factor());
  pair.shape_difference = 0.05;
  EXPECT_TRUE(pair.by_a_factor());
}

TEST(SpreadAtPeaks, IsThatOfH2OverH1) {
  FrfSet set = lines(5.0, 100.0, 1.0);
  add(set, {3, 3, 1}, {7, 3, 1}, [](complex s) {
    return exact_frf(positive, s);
  });
  EXPECT_NEAR(*spread_at_peaks(set.frfs[0]), 1.0 / 0.98 - 1.0, 1e-12);
  set.frfs[0].hits = 1;
  EXPECT_FALSE(spread_at_peaks(set.frfs[0]));
}

}  // namespace
}  // namespace tapfit::signal
