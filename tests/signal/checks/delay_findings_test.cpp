// Records of two sensors and two runs of six hits, of which one channel is
// later or earlier by a known number of samples from a known hit on.
#include "signal/checks/delay_findings.hpp"

#include "tests/signal/support/changing_test.hpp"

#include <gtest/gtest.h>

#include <random>
#include <string>

namespace tapfit::signal {
namespace {

GeneratedOptions six_hits(unsigned seed) {
  GeneratedOptions o;
  o.hits = 6;
  o.response_noise = 0.02;
  o.force_noise = 0.01;
  o.seed = seed;
  return o;
}

GeneratedTest plain_beam(unsigned seed) {
  return generate_structure(hung_beam(), six_hits(seed));
}

DelayChanges changes_of(const GeneratedTest& test, std::size_t run) {
  return delay_changes(
      test.bundle,
      test.hits,
      group_spectra(test.bundle, test.recordings, test.hits, {run}));
}

// The number of samples that is told.
double samples_told(const Finding& finding) {
  const std::size_t at = finding.what.find(" it comes ");
  return at == std::string::npos ? 0.0
                                 : std::stod(finding.what.substr(at + 10));
}

bool holds(const std::string& text, const std::string& part) {
  return text.find(part) != std::string::npos;
}

TEST(DelayFindings, CleanHitsHaveNone) {
  for (unsigned seed = 1; seed <= 40; seed += 2) {
    const GeneratedTest test = plain_beam(seed);
    for (const std::size_t run : {0U, 1U}) {
      EXPECT_TRUE(changes_of(test, run).findings.empty()) << seed;
    }
  }
}

// Of a cable that is off hits share what chance and the search for a delay make
// of so few.
TEST(DelayFindings, NoiseAloneHasNone) {
  for (const int hits : {2, 3, 4, 6}) {
    for (unsigned seed = 1; seed <= 30; ++seed) {
      GeneratedOptions options = six_hits(seed);
      options.hits = hits;
      GeneratedTest test = generate_structure(hung_beam(), options);
      std::mt19937 engine(seed);
      std::normal_distribution<double> noise(0.0, 1e-5);
      auto x = test.recordings[1].samples.col(2);
      for (double& value : x) value = noise(engine);
      EXPECT_TRUE(changes_of(test, 1).findings.empty()) << hits << " " << seed;
    }
  }
}

TEST(DelayFindings, NameChannelHitAndSize) {
  for (const double samples : {0.2, 1.0, 3.0, -1.0, -3.0, 40.0}) {
    for (unsigned seed = 1; seed <= 9; seed += 2) {
      GeneratedTest test = plain_beam(seed);
      delay_from(test, six_hits(seed), 1, 2, 3, samples);
      const DelayChanges found = changes_of(test, 1);
      ASSERT_EQ(found.findings.size(), 1U) << samples << " " << seed;
      const Finding& finding = found.findings[0];
      EXPECT_EQ(finding.where.channel, "acc2");
      EXPECT_EQ(finding.where.runs, std::vector<std::size_t>{1});
      EXPECT_EQ(finding.where.hit, 3U);
      // Five deviations by noise, as six hits of it have, are 0.03 samples; a
      // tenth of a sample is what is claimed.
      EXPECT_NEAR(samples_told(finding), std::abs(samples), 0.05) << seed;
      EXPECT_TRUE(holds(finding.what, samples > 0.0 ? "later" : "earlier"));
      EXPECT_TRUE(holds(finding.remedy, "leave hits 4 to 6 of run 2 out"));
      EXPECT_EQ(found.hits, (std::vector<HitAt>{{1, 3}, {1, 4}, {1, 5}}));
      EXPECT_TRUE(changes_of(test, 0).findings.empty());
    }
  }
}

TEST(DelayFindings, SaySamplesWereLostWhereTheyWere) {
  GeneratedTest test = plain_beam(3);
  auto x = test.recordings[1].samples.col(1);
  // Two samples are left out before the second hit; the rest moves up.
  const Eigen::Index at = begin_of(six_hits(3), 1);
  const Eigen::Index rest = x.size() - at - 2;
  x.segment(at, rest) = x.tail(rest).eval();
  const DelayChanges found = changes_of(test, 1);
  ASSERT_EQ(found.findings.size(), 1U);
  EXPECT_EQ(found.findings[0].where.channel, "acc1");
  EXPECT_TRUE(holds(found.findings[0].likely, "lost between the two hits"));
  EXPECT_TRUE(holds(found.findings[0].remedy, "leave hit 1 of run 2 out"));
}

TEST(DelayFindings, AllSensorsTogetherAreTheHammer) {
  GeneratedTest test = plain_beam(5);
  delay_from(test, six_hits(5), 0, 0, 4, 1.0);
  const DelayChanges found = changes_of(test, 0);
  ASSERT_EQ(found.findings.size(), 1U);
  EXPECT_EQ(found.findings[0].where.channel, "hammer");
  EXPECT_EQ(found.findings[0].where.hit, 4U);
  EXPECT_TRUE(holds(found.findings[0].what, "later against all sensors"));
}

TEST(DelayFindings, ADriftingClockIsNoStep) {
  GeneratedTest test = plain_beam(7);
  for (Eigen::Index hit = 1; hit < 6; ++hit) {
    delay_from(test, six_hits(7), 1, 2, hit, 0.3);
  }
  const DelayChanges found = changes_of(test, 1);
  ASSERT_EQ(found.findings.size(), 1U);
  EXPECT_TRUE(
      holds(found.findings[0].what, "grows evenly from hit 1 to hit 6"));
  EXPECT_EQ(found.hits.size(), 6U);
}

// A file for each hit: the runs' delays differ as hits of one run would.
TEST(DelayFindings, GoOverAllRunsOfAPlacement) {
  const GeneratedTest whole = [] {
    GeneratedTest test = plain_beam(9);
    delay_from(test, six_hits(9), 1, 2, 4, -1.0);
    return test;
  }();
  GeneratedTest parts = whole;
  parts.bundle.runs.assign(6, whole.bundle.runs[1]);
  parts.recordings.assign(6, whole.recordings[1]);
  parts.hits.runs.assign(6, whole.hits.runs[1]);
  for (std::size_t r = 0; r < 6; ++r) {
    for (std::size_t k = 0; k < 6; ++k) {
      parts.hits.runs[r][k].accepted = k == r;
    }
  }
  const DelayChanges found = delay_changes(
      parts.bundle,
      parts.hits,
      group_spectra(
          parts.bundle, parts.recordings, parts.hits, {0, 1, 2, 3, 4, 5}));
  ASSERT_EQ(found.findings.size(), 1U);
  EXPECT_EQ(found.findings[0].where.runs, std::vector<std::size_t>{4});
  EXPECT_TRUE(holds(found.findings[0].remedy, "leave run 5, run 6 out"));
}

// Phases that are turned near resonances only: a structure that warms up, one
// of which a mode falls with the force of the blow, one that was hit beside the
// point.
TEST(DelayFindings, AStructureThatChangesHasNone) {
  const auto with = [](double lower, double upper, double shape) {
    HungStructure structure = hung_beam();
    structure.modes[1].hz *= lower;
    structure.modes[2].hz *= upper;
    for (double& phi : structure.modes[2].phi) phi *= shape;
    return structure;
  };
  for (unsigned seed = 1; seed <= 3; seed += 2) {
    for (const double size : {0.0005, 0.002, 0.01}) {
      const auto warm = [&](int hit) {
        return with(1.0 - size * hit, 1.0 - size * hit, 1.0);
      };
      const auto soft = [&](int hit) {
        return with(1.0, 1.0 - size * (hit % 3), 1.0);
      };
      const auto beside = [&](int hit) {
        return with(1.0, 1.0, hit > 2 ? 1.0 + 20.0 * size : 1.0);
      };
      for (const auto& changing :
           std::vector<std::function<HungStructure(int)>>{warm, soft, beside}) {
        const GeneratedTest test = changing_structure(changing, six_hits(seed));
        for (const std::size_t run : {0U, 1U}) {
          for (const Finding& one : changes_of(test, run).findings) {
            ADD_FAILURE() << seed << " " << size << ": " << in_full(one);
          }
        }
      }
    }
  }
}

}  // namespace
}  // namespace tapfit::signal
