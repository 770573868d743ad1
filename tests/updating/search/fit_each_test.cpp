#include "updating/search/fit_each.hpp"

#include <gtest/gtest.h>

#include <vector>

namespace tapfit::updating {
namespace {

Hypothesis hypothesis(double error, double log_likelihood) {
  Hypothesis h;
  h.fit.result.error = error;
  h.fit.log_likelihood = log_likelihood;
  return h;
}

std::vector<double> errors(const std::vector<Hypothesis>& all) {
  std::vector<double> result;
  for (const Hypothesis& h : all) result.push_back(h.fit.result.error);
  return result;
}

// One is as good as the best, one may be, two are far from it.
TEST(DropHopeless, KeepsWhatMayBeTheAnswer) {
  std::vector<Hypothesis> all{hypothesis(0.10, 500.0),
                              hypothesis(0.05, 900.0),
                              hypothesis(0.06, 880.0),
                              hypothesis(0.20, 100.0)};
  drop_hopeless(all, 905.0);
  EXPECT_EQ(errors(all), (std::vector<double>{0.05, 0.06}));
}

// Of a kind that is out of reach what it can do is still told.
TEST(DropHopeless, KeepsTheBestOfAKind) {
  std::vector<Hypothesis> all{hypothesis(0.10, 500.0),
                              hypothesis(0.12, 520.0),
                              hypothesis(0.20, 100.0)};
  drop_hopeless(all, 900.0);
  EXPECT_EQ(errors(all), (std::vector<double>{0.12, 0.10}));
  std::vector<Hypothesis> none;
  drop_hopeless(none, 900.0);
  EXPECT_TRUE(none.empty());
}

}  // namespace
}  // namespace tapfit::updating
