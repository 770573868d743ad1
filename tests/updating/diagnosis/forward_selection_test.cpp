#include "updating/diagnosis/forward_selection.hpp"

#include "updating/catalogue/catalogue.hpp"

#include <gtest/gtest.h>

namespace tapfit::updating {
namespace {

Hypothesis explains(const std::string& effect,
                    const Eigen::Vector3d& residual,
                    double log_evidence,
                    std::vector<double> p = {1.0}) {
  Hypothesis h;
  h.fit.effects = {{&effects::find(effect), {}, std::move(p)}};
  h.fit.effects.back().where.node = 7;
  h.fit.result.residual = residual;
  h.log_evidence = log_evidence;
  return h;
}

// What remains of a sensor that never moved, as its mass or as any other mass
// there: the second is as likely in its predictions, not as a place among many.
const Eigen::Vector3d left = {0.010, -0.020, 0.015};
const Eigen::Vector3d nearly = {0.0101, -0.0199, 0.015};
const Eigen::Vector3d other = {-0.020, 0.010, 0.015};

CandidateRanking round_of(std::vector<Hypothesis> hypotheses) {
  CandidateRanking round;
  round.probability = {0.0, 1.0};
  round.probability.resize(hypotheses.size() + 1, 1e-9);
  round.hypotheses = std::move(hypotheses);
  return round;
}

TEST(ForwardSelection, WhatPredictsTheSameIsOneGroup) {
  const CandidateRanking round =
      round_of({explains("sensor-mass", left, 0.0),
                explains("added-mass", nearly, -20.0),
                explains("ground-spring", other, -20.0)});
  EXPECT_EQ(group_name(round, 0), "sensor-mass|added-mass");
  const std::vector<EffectRef> alike = indistinguishable(round, 0);
  ASSERT_EQ(alike.size(), 1U);
  EXPECT_EQ(alike[0].effect, "added-mass");
}

// It can always do what the simpler law does.
TEST(ForwardSelection, ALawWithMoreParametersIsNoLookAlike) {
  const CandidateRanking round =
      round_of({explains("added-mass", left, 0.0),
                explains("absorber", nearly, -20.0, {1.0, 1.0, 0.01})});
  EXPECT_EQ(group_name(round, 0), "added-mass");
  EXPECT_TRUE(indistinguishable(round, 0).empty());
}

// 20 : 1 is where evidence begins to be positive.
TEST(ForwardSelection, WhatIsNearlyAsLikelyIsNotToldApart) {
  CandidateRanking round = round_of({explains("added-mass", left, 0.0),
                                     explains("ground-spring", other, -2.9),
                                     explains("dashpot", other, -3.1)});
  round.probability = {0.0, 0.9, 0.055, 0.045};
  EXPECT_EQ(group_name(round, 0), "added-mass|ground-spring");
  EXPECT_EQ(indistinguishable(round, 0).size(), 1U);
}

// Two places of one kind at 0.27 each are likelier together than one of another
// kind at 0.45.
TEST(ForwardSelection, AKindIsAsLikelyAsItsPlacesTogether) {
  std::vector<Hypothesis> all{explains("prestress", left, 0.0),
                              explains("ground-spring", other, -0.5),
                              explains("ground-spring", nearly, -0.6),
                              explains("added-mass", left, -4.0)};
  put_likeliest_kind_first(all);
  EXPECT_EQ(all[0].own().effect->name(), "ground-spring");
  EXPECT_EQ(all[0].log_evidence, -0.5);
  EXPECT_EQ(all[1].own().effect->name(), "prestress");
  EXPECT_EQ(all[2].log_evidence, -0.6);
  std::vector<Hypothesis> none;
  put_likeliest_kind_first(none);
  EXPECT_TRUE(none.empty());
}

}  // namespace
}  // namespace tapfit::updating
