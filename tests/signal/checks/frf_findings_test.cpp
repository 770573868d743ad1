// Recordings with a known fault, from the samples to what is said of them.
#include "signal/checks/frf_findings.hpp"

#include "signal/checks/calibration_findings.hpp"
#include "signal/checks/reciprocity_findings.hpp"
#include "signal/estimate/estimate_frfs.hpp"
#include "tests/signal/support/generated_structure.hpp"

#include <gtest/gtest.h>

namespace tapfit::signal {
namespace {

using Findings = std::vector<Finding>;

struct Looked {
  FrfSet frfs;
  std::vector<DrivingPoint> points;
  std::vector<Reciprocal> pairs;
  Findings driving;
  Findings both_ways;
  Findings coherence;
  Findings spread;
};

Looked look(const GeneratedTest& test) {
  Looked all;
  all.frfs = estimate_frfs(test.bundle, test.recordings, test.hits, {});
  all.points = driving_points(all.frfs);
  all.pairs = reciprocals(all.frfs);
  all.driving = driving_point_findings(test.bundle, all.frfs, all.points);
  all.both_ways = reciprocity_findings(test.bundle, all.frfs, all.pairs);
  for (const auto& group : acquisition::runs_alike(test.bundle)) {
    const Findings more = coherence_findings(
        test.bundle,
        group_coherence(test.bundle, test.recordings, test.hits, group),
        group);
    all.coherence.insert(all.coherence.end(), more.begin(), more.end());
  }
  all.spread = spread_findings(all.frfs);
  return all;
}

GeneratedOptions noisy(unsigned seed) {
  GeneratedOptions o;
  o.hits = 4;
  o.response_noise = 0.02;
  o.force_noise = 0.01;
  o.seed = seed;
  return o;
}

bool says(const Findings& findings, const std::string& part) {
  return std::ranges::any_of(findings, [&](const Finding& f) {
    return in_full(f).find(part) != std::string::npos;
  });
}

std::string text(const Findings& findings) {
  std::string all;
  for (const auto& f : findings) all += in_full(f) + "\n";
  return all;
}

TEST(FrfFindings, AFairTestHasNone) {
  for (unsigned seed = 10; seed < 200; seed += 10) {
    const Looked all = look(generate_structure(hung_beam(), noisy(seed)));
    ASSERT_EQ(all.points.size(), 2U);
    ASSERT_EQ(all.pairs.size(), 1U);
    EXPECT_EQ(text(all.driving), "") << seed;
    EXPECT_EQ(text(all.both_ways), "") << seed;
    EXPECT_EQ(text(all.coherence), "") << seed;
    EXPECT_EQ(text(all.spread), "") << seed;
  }
}

TEST(FrfFindings, AWrongSensitivityShowsByItsFactor) {
  const GeneratedTest fair = generate_structure(hung_beam(), noisy(3));
  GeneratedTest test = fair;
  for (auto& recording : test.recordings) recording.samples.col(1) *= 0.8;
  const Looked before = look(fair);
  const Looked all = look(test);
  // 2 kg in closed form; the strings (0.3 of 5 Hz) and the bending modes (32 of
  // 10 Hz) leave a per cent, the same in both.
  EXPECT_EQ(all.points[0].low, LowLine::Mass);
  EXPECT_NEAR(before.points[0].mass_kg, 2.0, 0.06);
  EXPECT_NEAR(before.points[1].mass_kg, 2.0, 0.06);
  EXPECT_NEAR(all.points[0].mass_kg, before.points[0].mass_kg / 0.8, 1e-6);
  EXPECT_NEAR(all.points[1].mass_kg, before.points[1].mass_kg, 1e-6);
  // acc1 answers for A_12, acc2 for A_21.
  EXPECT_NEAR(std::abs(std::log(all.pairs[0].gain)), std::log(1.25), 0.005);
  EXPECT_TRUE(says(all.both_ways, "differ by a factor of"))
      << text(all.both_ways);
  EXPECT_TRUE(says(all.both_ways, "tapfit calibrate"));
  const auto at = [&](const Looked& of, double mass) {
    return mass_line_findings(test.bundle, of.frfs, of.points, mass);
  };
  EXPECT_EQ(text(at(before, 2.06)), "");
  const Findings heavy = at(all, 2.06);
  ASSERT_EQ(heavy.size(), 1U);
  EXPECT_TRUE(says(heavy, "1Z+ / 1Z+ (acc1)")) << text(heavy);
}

TEST(FrfFindings, AFactorOfAUnitIsNamedAsOne) {
  GeneratedTest test = generate_structure(hung_beam(), noisy(3));
  for (auto& recording : test.recordings) {
    recording.samples.col(2) /= 9.80665;
  }
  const Looked all = look(test);
  EXPECT_TRUE(says(all.both_ways, "9.807: g for m/s^2")) << text(all.both_ways);
  EXPECT_FALSE(says(all.both_ways, "tapfit calibrate"));
}

// A_12 = A_21 + c, c what the force leaves in acc's channel.
TEST(FrfFindings, ForceThatLeaksIntoASensorIsAConstant) {
  constexpr double leaks = 2.0;  // [(m/s^2)/N]; the beam of 2 kg has 0.5
  GeneratedTest test = generate_structure(hung_beam(), noisy(3));
  for (auto& recording : test.recordings) {
    recording.samples.col(2) += leaks * recording.samples.col(0);
  }
  const Looked all = look(test);
  ASSERT_EQ(all.pairs.size(), 1U);
  EXPECT_NEAR(std::abs(all.pairs[0].constant), leaks, 0.05 * leaks);
  EXPECT_TRUE(says(all.both_ways, "leaks into that of acc2"))
      << text(all.both_ways);
  EXPECT_FALSE(says(all.both_ways, "another one than written down"));
}

TEST(FrfFindings, SwappedChannelsShowAtTheDrivingPoints) {
  GeneratedTest test = generate_structure(hung_beam(), noisy(4));
  for (auto& recording : test.recordings) {
    const Eigen::VectorXd first = recording.samples.col(1);
    recording.samples.col(1) = recording.samples.col(2);
    recording.samples.col(2) = first;
  }
  const Looked all = look(test);
  ASSERT_EQ(all.points.size(), 2U);
  for (const DrivingPoint& point : all.points) {
    EXPECT_FALSE(point.fair());
    EXPECT_TRUE(point.rather);
  }
  EXPECT_EQ(all.driving.size(), 2U);
  EXPECT_TRUE(says(all.driving, "acc1 and acc2 are swapped"))
      << text(all.driving);
}

TEST(FrfFindings, ATurnedSensorAndATurnedHammerAreToldApart) {
  GeneratedTest test = generate_structure(hung_beam(), noisy(5));
  for (auto& recording : test.recordings) recording.samples.col(2) *= -1.0;
  const Looked sensor = look(test);
  ASSERT_EQ(sensor.driving.size(), 1U) << text(sensor.driving);
  EXPECT_TRUE(says(sensor.driving, "polarity of acc2"));
  EXPECT_TRUE(says(sensor.both_ways, "opposite signs"))
      << text(sensor.both_ways);
  for (auto& recording : test.recordings) recording.samples.col(1) *= -1.0;
  const Looked hammer = look(test);
  EXPECT_EQ(hammer.driving.size(), 2U);
  EXPECT_TRUE(says(hammer.driving, "polarity of the hammer"))
      << text(hammer.driving);
  EXPECT_EQ(text(hammer.both_ways), "");
}

// Node 2 written down, point 3 hit: neither a driving point nor the way back.
TEST(FrfFindings, AHitElsewhereIsNoDrivingPointAndNotReciprocal) {
  HungStructure structure = hung_beam();
  structure.hits[1] = 2;
  GeneratedTest test = generate_structure(structure, noisy(6));
  test.bundle.runs[1].hammer.dof.node = 2;
  const Looked all = look(test);
  EXPECT_TRUE(says(all.driving, "2Z+ / 2Z+ (acc2)")) << text(all.driving);
  EXPECT_TRUE(says(all.driving, "point down")) << text(all.driving);
  EXPECT_TRUE(says(all.both_ways, "whatever the factor"))
      << text(all.both_ways);
}

TEST(FrfFindings, ALooseSensorIsARowOfTheCoherenceMatrix) {
  GeneratedTest test = generate_structure(hung_beam(), noisy(7));
  std::mt19937_64 engine(1);
  std::normal_distribution<double> normal(0.0, 0.5);
  for (double& value : test.recordings[1].samples.col(2)) {
    value += normal(engine);
  }
  const Looked all = look(test);
  ASSERT_EQ(all.coherence.size(), 1U) << text(all.coherence);
  EXPECT_TRUE(says(all.coherence, "run-2.wav: acc2"));
}

TEST(FrfFindings, ABadHitIsAColumnOfTheCoherenceMatrix) {
  const GeneratedOptions o = noisy(8);
  GeneratedTest test = generate_structure(hung_beam(), o);
  HungStructure other = hung_beam();
  other.hits = {2, 2};
  const GeneratedTest elsewhere = generate_structure(other, o);
  const Eigen::Index row = o.lead + 2 * o.gap;
  test.recordings[0].samples.middleRows(row, o.gap) =
      elsewhere.recordings[0].samples.middleRows(row, o.gap);
  const Looked all = look(test);
  ASSERT_EQ(all.coherence.size(), 1U) << text(all.coherence);
  EXPECT_TRUE(says(all.coherence, "run-1.wav: hit 3 stands apart"));
}

TEST(FrfFindings, NoiseAtThePeaksSpreadsH1AndH2) {
  GeneratedTest test = generate_structure(hung_beam(), noisy(9));
  std::mt19937_64 engine(2);
  std::normal_distribution<double> normal(0.0, 4.0);
  for (double& value : test.recordings[0].samples.col(1)) {
    value += normal(engine);
  }
  const Looked all = look(test);
  ASSERT_EQ(all.spread.size(), 1U);
  EXPECT_TRUE(says(all.spread, "1Z+ / 1Z+ (run 1)")) << text(all.spread);
}

// A free mass of 2 kg, its sensor 3 % too sensitive, turned, and one sample
// (1/512 s) late.
TEST(CalibrationFindings, SayWhatToEnter) {
  HungStructure mass = hung_beam();
  mass.modes.resize(1);
  // Strings that turn the phase at 5 Hz by 0.4 % only.
  mass.modes[0].hz = 0.2;
  mass.modes[0].zeta = 0.05;
  mass.sensors = {0};
  mass.hits = {0};
  GeneratedTest test = generate_structure(mass, noisy(11));
  test.bundle.channels[1].sensitivity = 0.01;
  const auto found = [&] {
    const FrfSet frfs =
        estimate_frfs(test.bundle, test.recordings, test.hits, {});
    return calibration_findings(test.bundle, frfs, calibrate(frfs, 2.0));
  };
  EXPECT_EQ(text(found()), "");
  Eigen::MatrixXd& x = test.recordings[0].samples;
  const Eigen::VectorXd late = x.col(1).head(x.rows() - 1);
  x.col(1).tail(x.rows() - 1) = -1.03 * late;
  const Findings all = found();
  EXPECT_TRUE(says(all, "times what it should")) << text(all);
  EXPECT_TRUE(says(all, "the sensitivity of acc1 is 0.0103")) << text(all);
  EXPECT_TRUE(says(all, "polarity is inverted")) << text(all);
  EXPECT_TRUE(says(all, "behind the hammer")) << text(all);
  const FrfSet frfs =
      estimate_frfs(test.bundle, test.recordings, test.hits, {});
  const Calibration c = calibrate(frfs, 2.0).at(0);
  // The strings: 0.2 of 5 Hz, squared.
  EXPECT_NEAR(c.gain, -1.03, 0.0016 * 1.03);
  EXPECT_NEAR(c.delay_s, 1.0 / 512.0, 3e-5);
  // A flexible body is no mass: said, and the band to take.
  HungStructure beam = hung_beam();
  beam.sensors = {0};
  beam.hits = {0};
  test = generate_structure(beam, noisy(12));
  const Findings flexible = found();
  EXPECT_TRUE(says(flexible, "answers as a mass alone only to"))
      << text(flexible);
}

}  // namespace
}  // namespace tapfit::signal
