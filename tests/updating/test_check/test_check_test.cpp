// One mistake at a time in tests that are otherwise clean, and clean ones.
#include "updating/test_check/test_check.hpp"

#include "acquisition/foundation/constants.hpp"
#include "tests/acquisition/support/temporary_folder.hpp"
#include "tests/updating/support/check_score.hpp"
#include "tests/updating/support/test_mistakes.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cctype>
#include <cmath>
#include <fstream>
#include <iterator>
#include <map>
#include <string>
#include <vector>

namespace tapfit::updating {
namespace {

using testing::Mistake;
using testing::PlainOptions;
using testing::SheetAndRecords;

PlainOptions structure(unsigned seed) {
  PlainOptions options;
  options.seed = seed;
  options.structure = static_cast<testing::Structure>((seed + 2) % 5);
  options.sensors = 2 + static_cast<int>(seed % 2);
  return options;
}

TEST(TestCheck, CleanTestsHaveNoFault) {
  for (unsigned seed = 1; seed <= 6; ++seed) {
    const TestCheck found = testing::check_of(plain_test(structure(seed)));
    EXPECT_EQ(testing::serious(found.findings), "") << seed;
    EXPECT_TRUE(found.may_go_on()) << seed;
    EXPECT_FALSE(found.records.empty());
    EXPECT_FALSE(found.points.empty());
  }
}

struct Weak {
  const char* what;
  PlainOptions test;
};

PlainOptions drawn(unsigned seed,
                   testing::Structure structure,
                   int sensors,
                   int runs,
                   double noise) {
  PlainOptions options;
  options.seed = seed;
  options.structure = structure;
  options.sensors = sensors;
  options.runs = runs;
  options.noise = noise;
  return options;
}

// Of five hundred clean tests those that were once found to be faulty for a
// reason of their own (tests/studies/check_study.cpp).
TEST(TestCheck, WeakSignalsAreNoFault) {
  using enum testing::Structure;
  for (const auto& [what, test] : {
           Weak{"sensor and blow near the clamp",
                drawn(4798, ClampedBeam, 3, 8, 1.0)},
           Weak{"peaks without a phase", drawn(4853, ClampedBeam, 4, 6, 0.3)},
           Weak{"sensor that barely leaves its noise",
                drawn(4873, ClampedBeam, 3, 5, 1.0)},
           Weak{"two close modes, taken as one",
                drawn(4906, HeldPlate, 3, 12, 3.0)},
           Weak{"mode that one run shows", drawn(5035, FreePlate, 3, 6, 3.0)},
       }) {
    EXPECT_EQ(testing::serious(testing::check_of(plain_test(test)).findings),
              "")
        << what;
  }
}

/// Made once for all mistakes that are made in it.
const SheetAndRecords& clean_test(unsigned seed) {
  static std::map<unsigned, SheetAndRecords> made;
  const auto [it, fresh] = made.try_emplace(seed);
  if (fresh) it->second = plain_test(structure(seed));
  return it->second;
}

std::vector<Finding> of_severity(const std::vector<Finding>& all, Severity s) {
  std::vector<Finding> found;
  std::ranges::copy_if(all, std::back_inserter(found), [s](const Finding& f) {
    return f.severity == s;
  });
  return found;
}

// Of twelve runs nine have one sensor's range changed: the three before it
// differ from most, whichever sensor explains each of them best.
TEST(TestCheck, OneChangeOfARangeIsOneFinding) {
  const PlainOptions options =
      drawn(12, testing::Structure::FreeBeam, 2, 12, 1.0);
  SheetAndRecords test = plain_test(options);
  for (std::size_t r = 3; r < 12; ++r) {
    test.recordings[r].samples.col(1) *= 1.3;
  }
  const TestCheck found = testing::check_of(test);
  const auto errors = of_severity(found.findings, Severity::Error);
  ASSERT_EQ(errors.size(), 1U) << testing::serious(found.findings);
  EXPECT_EQ(errors[0].where.runs, (std::vector<std::size_t>{0, 1, 2}));
  EXPECT_NE(errors[0].what.find("from run 4 on"), std::string::npos)
      << errors[0].what;
  // Of two sensors either may have been changed.
  EXPECT_NE(errors[0].remedy.find("(or acc"), std::string::npos)
      << errors[0].remedy;
}

// Hits found in a response say nothing of trigger, cables and structure.
TEST(TestCheck, WhatAnExchangeExplainsIsSaidOnce) {
  for (const unsigned seed : {3U, 4U}) {
    SheetAndRecords test = clean_test(seed);
    for (auto& r : test.recordings) r.samples.col(0).swap(r.samples.col(1));
    const TestCheck found = testing::check_of(test);
    const auto errors = of_severity(found.findings, Severity::Error);
    ASSERT_EQ(errors.size(), 1U) << testing::serious(found.findings);
    EXPECT_NE(errors[0].likely.find("exchanged"), std::string::npos);
  }
}

/// A beam of which three sensors' points are hit.
SheetAndRecords driven_beam(unsigned seed) {
  return plain_test(drawn(seed, testing::Structure::FreeBeam, 3, 8, 1.0));
}

/// Runs whose blow is at a sensor.
std::vector<std::size_t> driven_runs(const SheetAndRecords& test) {
  std::vector<std::size_t> runs;
  for (std::size_t r = 0; r < test.bundle.runs.size(); ++r) {
    const acquisition::Run& run = test.bundle.runs[r];
    const bool driven = std::ranges::any_of(run.sensors, [&](const auto& s) {
      return s.dof.node == run.hammer.dof.node;
    });
    if (driven) runs.push_back(r);
  }
  return runs;
}

/// Errors that are there, and how many of them hold the words.
struct Said {
  std::size_t errors = 0;
  std::size_t with_words = 0;
};

Said errors_with(const TestCheck& found, const char* words) {
  const auto errors = of_severity(found.findings, Severity::Error);
  const auto with_words = std::ranges::count_if(errors, [&](const Finding& f) {
    return in_full(f).find(words) != std::string::npos;
  });
  return {errors.size(), static_cast<std::size_t>(with_words)};
}

// Else the sensors seem to have moved in that run.
TEST(TestCheck, AnExchangeInOneRunIsNoMovedSensor) {
  SheetAndRecords test = driven_beam(7);
  const std::vector<std::size_t> runs = driven_runs(test);
  ASSERT_FALSE(runs.empty());
  const acquisition::Run& run = test.bundle.runs[runs.front()];
  Eigen::MatrixXd& x = test.recordings[runs.front()].samples;
  // With the one that is hit.
  const auto hit = std::ranges::find_if(run.sensors, [&](const auto& s) {
    return s.dof.node == run.hammer.dof.node;
  });
  const auto other = hit == run.sensors.begin() ? hit + 1 : hit - 1;
  x.col(static_cast<Eigen::Index>(hit->channel))
      .swap(x.col(static_cast<Eigen::Index>(other->channel)));
  const TestCheck found = testing::check_of(test);
  const Said said = errors_with(found, "are swapped in this run");
  EXPECT_EQ(said.with_words, 1U) << testing::serious(found.findings);
  EXPECT_EQ(said.errors, 1U) << testing::serious(found.findings);
}

TEST(TestCheck, FilesInAnotherOrderAreNoOtherQuantity) {
  SheetAndRecords test = driven_beam(7);
  std::ranges::rotate(test.recordings, test.recordings.begin() + 1);
  const TestCheck found = testing::check_of(test);
  const std::string all = testing::serious(found.findings);
  EXPECT_NE(all.find("; the sensors agree with those of the other runs: the "
                     "blow was at 2Z+, or the file is another run's"),
            std::string::npos)
      << all;
  EXPECT_EQ(all.find("swapped"), std::string::npos) << all;
  EXPECT_EQ(all.find("displacement"), std::string::npos) << all;
  EXPECT_EQ(all.find("in this run"), std::string::npos) << all;
}

TEST(TestCheck, AToneIsSaidBeforeWhatItMakes) {
  SheetAndRecords test = driven_beam(7);
  for (std::size_t r = 0; r < test.recordings.size(); ++r) {
    acquisition::Recording& recording = test.recordings[r];
    auto x = recording.samples.col(1);
    const double size = 0.05 * x.cwiseAbs().maxCoeff();
    for (Eigen::Index k = 0; k < x.size(); ++k) {
      const double t = static_cast<double>(k) / recording.sample_rate_hz;
      x(k) += size * std::sin(two_pi * 50.0 * t + 1.7 * static_cast<double>(r));
    }
  }
  const TestCheck found = testing::check_of(test);
  const std::string all = testing::serious(found.findings);
  EXPECT_TRUE(found.may_go_on()) << all;
  ASSERT_FALSE(found.findings.empty());
  EXPECT_NE(found.findings.front().what.find("steady tone of 50 Hz"),
            std::string::npos)
      << all;
}

TEST(TestCheck, ThatNoRunCanBeUsedIsSaid) {
  SheetAndRecords test = clean_test(3);
  for (auto& r : test.recordings) r.samples.col(0).setZero();
  const std::string dead = testing::serious(testing::check_of(test).findings);
  EXPECT_NE(dead.find("and so in each of the 8 runs"), std::string::npos)
      << dead;
  for (auto& r : test.recordings) r.samples = r.samples.topRows(1).eval();
  const std::string cut = testing::serious(testing::check_of(test).findings);
  EXPECT_NE(cut.find("one sample long"), std::string::npos) << cut;
}

TEST(TestCheck, AFileOfAnotherRateIsNamedWithoutACause) {
  SheetAndRecords test = clean_test(3);
  test.recordings[4].sample_rate_hz *= 2.0;
  const TestCheck found = testing::check_of(test);
  const auto errors = of_severity(found.findings, Severity::Error);
  ASSERT_FALSE(errors.empty());
  EXPECT_NE(errors[0].what.find("is sampled at"), std::string::npos);
  EXPECT_NE(errors[0].what.find(test.bundle.runs[4].file.filename().string()),
            std::string::npos)
      << errors[0].what;
  EXPECT_EQ(errors[0].likely, "");
}

TEST(TestCheck, AHammerInKilonewtonsIsNamedByItsUnit) {
  SheetAndRecords test = clean_test(3);
  test.bundle.channels[0].sensitivity *= 1000.0;
  const std::string said = testing::serious(testing::check_of(test).findings);
  EXPECT_NE(said.find("1000: kN for N"), std::string::npos) << said;
  EXPECT_EQ(said.find("e+0"), std::string::npos) << said;
}

class AMistake : public ::testing::TestWithParam<Mistake> {};

TEST_P(AMistake, IsNamed) {
  const Mistake& mistake = GetParam();
  for (const unsigned seed : {3U, 4U}) {
    SheetAndRecords test = clean_test(seed);
    mistake.make(test, structure(seed), 0.7);
    const TestCheck found = testing::check_of(test);
    EXPECT_TRUE(testing::is_named(mistake, found.findings))
        << "structure " << seed << ":\n"
        << testing::serious(found.findings);
  }
}

// docs/faulty-tests.md promises these words.
TEST(Mistakes, StandInTheDocumentsWithTheirWords) {
  std::ifstream file(TAPFIT_SOURCE_DIR "/docs/faulty-tests.md");
  const std::string page{std::istreambuf_iterator<char>(file), {}};
  ASSERT_FALSE(testing::mistakes().empty());
  for (const Mistake& mistake : testing::mistakes()) {
    std::string words;
    for (const std::string& all : mistake.words) {
      words += words.empty() ? "" : ", ";
      for (const char c : all) words += c == '|' ? " or " : std::string(1, c);
    }
    EXPECT_NE(page.find("| " + mistake.name + " | " + words + " |"),
              std::string::npos)
        << mistake.name;
  }
}

// Those that are not yet found on every structure: a range changed or a
// structure that warms up between runs shows only where modes lie apart and
// points are measured again. The study of these mistakes counts them.
std::vector<Mistake> found_everywhere() {
  std::vector<Mistake> all = testing::mistakes();
  std::erase_if(all, [](const Mistake& mistake) {
    return mistake.name == "range changed in one run" ||
           mistake.name == "range changed from a run on" ||
           mistake.name == "structure warms up";
  });
  return all;
}

std::string test_name(const ::testing::TestParamInfo<Mistake>& info) {
  std::string name;
  for (const char c : info.param.name) {
    name += std::isalnum(static_cast<unsigned char>(c)) != 0 ? c : '_';
  }
  return name;
}

INSTANTIATE_TEST_SUITE_P(One,
                         AMistake,
                         ::testing::ValuesIn(found_everywhere()),
                         test_name);

}  // namespace
}  // namespace tapfit::updating
