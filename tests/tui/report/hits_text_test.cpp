// The writer of hits, on hits made by hand; fields as docs/test-bundle.md and
// the format of results promise.
#include "tui/report/hits_text.hpp"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

namespace tapfit::tui {
namespace {

acquisition::TestBundle sample_bundle() {
  acquisition::TestBundle bundle;
  bundle.channels.resize(2);
  bundle.channels[0].name = "hammer";
  bundle.channels[1].name = "acc1";
  acquisition::Run run;
  run.file = "/somewhere/run-01.wav";
  run.hammer = {.channel = 0, .dof = {.node = 3, .component = 3, .sign = 1}};
  run.sensors = {
      {.channel = 1, .dof = {.node = 12, .component = 3, .sign = 1}}};
  bundle.runs.push_back(run);
  return bundle;
}

acquisition::HitSet sample_hits() {
  acquisition::Hit good;
  good.time_s = 1.25;
  good.peak_n = 21.5;
  acquisition::Hit bad;
  bad.time_s = 5.5;
  bad.peak_n = 90.0;
  bad.accepted = false;
  bad.reasons = {acquisition::HitFault::Double,
                 acquisition::HitFault::Overload};
  bad.second = acquisition::SecondPulse{
      .share = 0.25, .after_s = 0.5, .loss_db = 2.5, .outside = 0.03125};
  acquisition::HitSet hits;
  hits.runs = {{good, bad}};
  hits.statements = {"block 4 s"};
  return hits;
}

TEST(HitsText, JsonHasThePromisedFields) {
  const auto json = hits_json(sample_bundle(), sample_hits());
  const auto& run = json.at("runs").at(0);
  EXPECT_EQ(run.at("file"), "run-01.wav");
  ASSERT_EQ(run.at("hits").size(), 2U);
  EXPECT_EQ(run.at("hits").at(0).dump(),
            R"({"time_s":1.25,"peak_n":21.5,"accepted":true,"reasons":[]})");
  EXPECT_EQ(run.at("hits").at(1).at("reasons").dump(),
            R"(["double","overload"])");
  EXPECT_EQ(
      run.at("hits").at(1).at("second_blow").dump(),
      R"({"percent":25.0,"after_s":0.5,"force_loss_db":2.5,"response_outside_percent":3.125})");
}

TEST(HitsText, TextCountsAndGivesReasons) {
  const std::string text = hits_text(sample_bundle(), sample_hits());
  EXPECT_NE(text.find("Hits: 2 found, 1 accepted"), std::string::npos) << text;
  EXPECT_NE(text.find("double, overload"), std::string::npos) << text;
  EXPECT_NE(text.find("12Z+ (acc1)"), std::string::npos) << text;
  EXPECT_NE(text.find("block 4 s"), std::string::npos) << text;
}

TEST(HitsText, TextSaysWhenNoneIsRejected) {
  auto hits = sample_hits();
  hits.runs[0].pop_back();
  const std::string text = hits_text(sample_bundle(), hits);
  EXPECT_NE(text.find("none rejected"), std::string::npos) << text;
}

}  // namespace
}  // namespace tapfit::tui
