#include "updating/robustness/setting_change.hpp"

#include <gtest/gtest.h>

#include <set>
#include <string>
#include <vector>

namespace tapfit::updating {
namespace {

/// Two FRFs of each run; one property of the deck, two of its mesh.
FitProblem problem_of(std::size_t runs) {
  FitProblem problem;
  problem.uncertain_sd = {0.03, 0.1, 0.2};
  Target target;
  for (std::size_t run = 0; run < runs; ++run) {
    for (int sensor = 0; sensor < 2; ++sensor) {
      target.run.push_back(run);
      target.use.push_back(1.0);
    }
  }
  problem.targets = {target, target};
  return problem;
}

const std::vector<PropertyName> properties{{"E:1", "Pa", 70e9}};

std::vector<std::string> words_of(std::size_t runs) {
  std::vector<std::string> words;
  for (const auto& change : setting_changes(problem_of(runs), properties)) {
    words.push_back(change.what);
  }
  return words;
}

TEST(SettingChanges, AreOfEachThingThatWasAssumed) {
  EXPECT_EQ(
      words_of(2),
      (std::vector<std::string>{"prior of E:1 halved",
                                "prior of E:1 doubled",
                                "prior of the model's corrections halved",
                                "prior of the model's corrections doubled",
                                "prior of damping halved",
                                "prior of damping doubled",
                                "E:1 held at the deck's value",
                                "allowance for form halved",
                                "allowance for form doubled",
                                "run 1 left out",
                                "run 2 left out"}));
  // A single run cannot be left out.
  EXPECT_EQ(words_of(1).size(), 9U);
}

TEST(SettingChanges, OfModesLeaveDampingAndRunsAlone) {
  FitProblem problem = problem_of(1);
  for (Target& target : problem.targets) target.modal_sd = 1e-3;
  std::vector<std::string> words;
  for (const auto& change : setting_changes(problem, properties)) {
    words.push_back(change.what);
  }
  EXPECT_EQ(
      words,
      (std::vector<std::string>{"prior of E:1 halved",
                                "prior of E:1 doubled",
                                "prior of the model's corrections halved",
                                "prior of the model's corrections doubled",
                                "E:1 held at the deck's value",
                                "allowance for form halved",
                                "allowance for form doubled"}));
}

TEST(SettingChanges, ManyRunsGoInTenGroupsThatHoldEachOnce) {
  std::multiset<std::size_t> held;
  std::size_t groups = 0;
  for (const auto& change : setting_changes(problem_of(24), properties)) {
    if (change.left_out.empty()) continue;
    ++groups;
    EXPECT_LE(change.left_out.size(), 3U);
    held.insert(change.left_out.begin(), change.left_out.end());
  }
  EXPECT_EQ(groups, 10U);
  EXPECT_EQ(held.size(), 24U);
  EXPECT_EQ(std::set<std::size_t>(held.begin(), held.end()).size(), 24U);
  EXPECT_EQ(words_of(24).back(), "runs 22 to 24 left out");
}

TEST(SettingChanges, AreCarriedOut) {
  const FitProblem problem = problem_of(3);
  const auto under = [&problem](const std::string& what) {
    for (const auto& change : setting_changes(problem, properties)) {
      if (change.what == what) return changed(problem, change);
    }
    ADD_FAILURE() << "no " << what;
    return problem;
  };
  EXPECT_EQ(under("prior of E:1 halved").uncertain_sd,
            (std::vector<double>{0.015, 0.1, 0.2}));
  EXPECT_EQ(under("prior of the model's corrections doubled").uncertain_sd,
            (std::vector<double>{0.03, 0.2, 0.4}));
  EXPECT_EQ(under("prior of damping doubled").damping_spread,
            2.0 * problem.damping_spread);
  EXPECT_EQ(under("allowance for form halved").form_allowance, 0.5);
  EXPECT_LT(under("E:1 held at the deck's value").uncertain_sd[0], 1e-5);
  const FitProblem fewer = under("run 2 left out");
  for (const Target& target : fewer.targets) {
    EXPECT_EQ(target.use, (std::vector<double>{1, 1, 0, 0, 1, 1}));
  }
  EXPECT_EQ(problem.targets[0].use[2], 1.0) << "the given one stays";
}

}  // namespace
}  // namespace tapfit::updating
