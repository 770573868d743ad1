#include "acquisition/checks/rejected_hits.hpp"

#include "tests/support/matchers.hpp"

namespace tapfit::acquisition {
namespace {

TestBundle one_run() {
  TestBundle bundle;
  bundle.channels.resize(1);
  bundle.channels[0].name = "hammer";
  bundle.runs.resize(1);
  return bundle;
}

std::vector<Recording> one_recording() {
  std::vector<Recording> recordings(1);
  recordings[0].samples = Eigen::MatrixXd::Zero(100, 1);
  return recordings;
}

Hit rejected_hit(const SecondPulse& second) {
  Hit hit;
  hit.accepted = false;
  hit.second = second;
  hit.reasons = {HitFault::Double, HitFault::Truncated};
  return hit;
}

// As many hits are noted as double as end too early; the second blow costs
// nothing, so the end alone is to be mended.
TEST(RejectedHits, ASecondBlowThatCostsLittleIsNotBlamed) {
  HitSet hits;
  SecondPulse harmless;
  harmless.share = 0.3;
  hits.runs = {{rejected_hit(harmless), rejected_hit(harmless)}};
  const auto findings = rejected_hit_findings(one_run(), one_recording(), hits);
  ASSERT_EQ(findings.size(), 1U);
  EXPECT_EQ(findings[0].what, "none of its 2 hits is accepted: 2 truncated");
  EXPECT_THAT(findings[0].remedy, HasSubstr("the file's end"));
}

// Of the same reason, though not of the same number of hits.
TEST(RejectedHits, RunsOfOneReasonAreOneFinding) {
  TestBundle bundle = one_run();
  bundle.runs.resize(3);
  std::vector<Recording> recordings(3, one_recording()[0]);
  Hit early;
  early.accepted = false;
  early.reasons = {HitFault::Truncated};
  Hit soft = early;
  soft.reasons = {HitFault::Soft};
  HitSet hits;
  hits.runs = {{early, early}, {soft}, {early}};
  const auto findings = rejected_hit_findings(bundle, recordings, hits);
  ASSERT_EQ(findings.size(), 2U);
  EXPECT_EQ(findings[0].where.runs, (std::vector<std::size_t>{0, 2}));
  EXPECT_EQ(findings[0].what, "none of their 3 hits is accepted: 3 truncated");
  EXPECT_EQ(findings[1].where.runs, std::vector<std::size_t>{1});
}

TEST(RejectedHits, ASecondBlowThatLeavesTheBlockIs) {
  HitSet hits;
  SecondPulse late;
  late.leaves_block = true;
  hits.runs = {{rejected_hit(late)}};
  const auto findings = rejected_hit_findings(one_run(), one_recording(), hits);
  ASSERT_EQ(findings.size(), 1U);
  EXPECT_THAT(findings[0].what, HasSubstr("1 double, 1 truncated"));
}

}  // namespace
}  // namespace tapfit::acquisition
