#include "updating/diagnosis/candidate_ranking.hpp"

#include "updating/catalogue/catalogue.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace tapfit::updating {
namespace {

Hypothesis at_node(const char* effect, int node, double size, double evidence) {
  Hypothesis h;
  EffectInstance own;
  own.effect = &effects::find(effect);
  own.where.node = node;
  own.p = {size};
  h.fit.effects = {own};
  h.log_evidence = evidence;
  h.log_gain = evidence;
  return h;
}

// All places of a kind count together: two fair springs are likelier than one
// good mass.
TEST(ARanking, LeadsWithTheLikeliestKind) {
  std::vector<Hypothesis> all = {at_node("added-mass", 1, 0.1, 10.0),
                                 at_node("ground-spring", 2, 1e3, 9.5),
                                 at_node("ground-spring", 3, 1e3, 9.4)};
  put_likeliest_kind_first(all);
  EXPECT_EQ(all.front().own().where.node, 2);
  EXPECT_EQ(all[1].own().where.node, 1);
}

// A spring to ground and a cable at the same sensor say nearly the same; that
// springs were looked for at three hundred grids tells none from the other.
TEST(ARanking, GroupsWhatOnlyTheNumberOfPlacesTellsApart) {
  CandidateRanking round;
  const double searched = std::log(300.0);
  round.hypotheses = {at_node("sensor-cable", 1, 1e3, 20.0),
                      at_node("ground-spring", 1, 1e3, 21.0 - searched),
                      at_node("added-mass", 1, 0.1, 12.0)};
  round.hypotheses[1].places = 300.0;
  round.probability = {0.0, 0.99, 0.01, 0.0};
  EXPECT_EQ(group_name(round, 0), "sensor-cable|ground-spring");
  const std::vector<EffectRef> alike = indistinguishable(round, 0);
  ASSERT_EQ(alike.size(), 1U);
  EXPECT_EQ(alike.front().effect, "ground-spring");
}

TEST(ARanking, PutsNoneOnTheScaleOfTheOthers) {
  CandidateRanking round;
  round.hypotheses = {at_node("added-mass", 1, 0.1, 10.0)};
  round.hypotheses.front().log_gain = 3.0;
  EXPECT_DOUBLE_EQ(round.none_evidence(), 7.0);
}

TEST(ARanking, WidensASizeByThoseAtOtherPlaces) {
  CandidateRanking round;
  round.hypotheses = {at_node("dashpot", 1, 2.0, 10.0),
                      at_node("dashpot", 2, 4.0, 10.0)};
  round.probability = {0.0, 0.5, 0.5};
  // ln 2 off in half of all cases.
  EXPECT_NEAR(place_sd(round, 0).at(0), std::log(2.0) * M_SQRT1_2, 1e-12);
}

// A dashpot that a fit took to nothing, 690 off in the logarithm, is none.
TEST(ARanking, WidensNoSizeByWhereTheEffectVanished) {
  CandidateRanking round;
  round.hypotheses = {at_node("dashpot", 1, 2.0, 10.0),
                      at_node("dashpot", 2, 1e-300, -6.0)};
  round.probability = {0.0, 0.997, 0.003};
  EXPECT_EQ(place_sd(round, 0).at(0), 0.0);
}

}  // namespace
}  // namespace tapfit::updating
