#include "updating/search/fit_each.hpp"

#include "tests/updating/support/plain_hypothesis.hpp"

#include <gtest/gtest.h>

#include <vector>

namespace tapfit::updating {
namespace {

std::vector<double> errors(const std::vector<Hypothesis>& all) {
  std::vector<double> result;
  for (const Hypothesis& h : all) result.push_back(h.fit.result.error);
  return result;
}

std::vector<Hypothesis> judged(const Reach& reach,
                               const std::vector<double>& all) {
  std::vector<Hypothesis> result;
  for (const double error : all) {
    result.push_back(reach.judged(plain_hypothesis(error).fit));
  }
  return result;
}

// One is as good as the best, one may be, two are far from it.
TEST(DropHopeless, KeepsWhatMayBeTheAnswer) {
  Reach reach(50.0, 1e-3);
  std::vector<Hypothesis> all = judged(reach, {0.10, 0.05, 0.06, 0.20});
  for (const Hypothesis& h : all) reach.take(h);
  drop_hopeless(all, reach);
  EXPECT_EQ(errors(all), (std::vector<double>{0.05, 0.06}));
}

// Of a kind that is out of reach what it can do is still told.
TEST(DropHopeless, KeepsTheBestOfAKind) {
  Reach reach(50.0, 1e-3);
  std::vector<Hypothesis> all = judged(reach, {0.12, 0.10, 0.20});
  reach.take(judged(reach, {0.05}).front());
  drop_hopeless(all, reach);
  EXPECT_EQ(errors(all), (std::vector<double>{0.10}));
  std::vector<Hypothesis> none;
  drop_hopeless(none, reach);
  EXPECT_TRUE(none.empty());
}

}  // namespace
}  // namespace tapfit::updating
