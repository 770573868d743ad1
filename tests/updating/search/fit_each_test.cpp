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

// One is as good as the best, one may be, two are far from it.
TEST(DropHopeless, KeepsWhatMayBeTheAnswer) {
  std::vector<Hypothesis> all{plain_hypothesis(0.10),
                              plain_hypothesis(0.05),
                              plain_hypothesis(0.06),
                              plain_hypothesis(0.20)};
  Reach reach(50.0, 1e-3);
  for (const Hypothesis& h : all) reach.take(h.fit);
  drop_hopeless(all, reach);
  EXPECT_EQ(errors(all), (std::vector<double>{0.05, 0.06}));
}

// Of a kind that is out of reach what it can do is still told.
TEST(DropHopeless, KeepsTheBestOfAKind) {
  std::vector<Hypothesis> all{
      plain_hypothesis(0.12), plain_hypothesis(0.10), plain_hypothesis(0.20)};
  Reach reach(50.0, 1e-3);
  reach.take(plain_hypothesis(0.05).fit);
  drop_hopeless(all, reach);
  EXPECT_EQ(errors(all), (std::vector<double>{0.10}));
  std::vector<Hypothesis> none;
  drop_hopeless(none, reach);
  EXPECT_TRUE(none.empty());
}

}  // namespace
}  // namespace tapfit::updating
