#include "tui/commands/diagnose_command.hpp"

#include "tui/report/effect_output.hpp"
#include "updating/diagnosis/named_diagnosis.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <limits>

namespace tapfit::tui {
namespace {

updating::Location at_node(int node) {
  updating::Location where;
  where.node = node;
  return where;
}

updating::Location at_channels(std::vector<std::string> channels) {
  updating::Location where;
  where.channels = std::move(channels);
  return where;
}

updating::Diagnosis sample_diagnosis() {
  const updating::Estimate mass{.name = "mass_kg",
                                .value = 0.0785,
                                .sd = 0.0006,
                                .lo95 = 0.0773,
                                .hi95 = 0.0797};
  updating::Diagnosis diagnosis;
  diagnosis.verdict = "added-mass";
  diagnosis.error_base = 0.388;
  diagnosis.error_best = 0.038;
  diagnosis.floor = 0.031;
  diagnosis.candidates = {{.effect = "added-mass",
                           .where = at_node(201),
                           .parameters = {mass},
                           .probability = 0.998,
                           .error = 0.038,
                           .held_out_error = 0.04,
                           .indistinguishable_from = {}}};
  diagnosis.ladder = {{.added = "added-mass",
                       .where = at_node(201),
                       .error = 0.038,
                       .parameters = {mass}}};
  diagnosis.model_parameters = {{.name = "E:1",
                                 .value = 7.07e10,
                                 .sd = 2e8,
                                 .lo95 = 7.03e10,
                                 .hi95 = 7.11e10,
                                 .unit = "Pa"}};
  return diagnosis;
}

// Where nothing can be told apart, the kinds say it and a hundred places do
// not.
TEST(DiagnoseCommand, CountsLookAlikesByKind) {
  updating::Diagnosis diagnosis = sample_diagnosis();
  auto& alike = diagnosis.candidates[0].indistinguishable_from;
  for (int node = 1; node <= 40; ++node) {
    alike.push_back({"support-mismatch", at_node(node)});
  }
  alike.push_back({"sensor-mass", at_channels({"acc1"})});
  const auto row = [&diagnosis] {
    const std::string text = diagnosis_text(diagnosis);
    const std::size_t at = text.find("or support-mismatch");
    return at == std::string::npos ? text
                                   : text.substr(at, text.find('\n', at) - at);
  };
  EXPECT_EQ(row(), "or support-mismatch at 40 places, sensor-mass at acc1");
  alike.push_back({"joint", at_node(1)});
  alike.push_back({"joint", at_node(2)});
  alike.push_back({"dashpot", at_node(2)});
  EXPECT_TRUE(row().ends_with(", joint at 2 places, 1 other kind")) << row();
}

// A support's rotation and its translation are two forms of one effect.
TEST(DiagnoseCommand, JsonNamesEachLookAlikeOnceAndNotTheCandidate) {
  updating::Diagnosis diagnosis = sample_diagnosis();
  updating::Location rotation;
  rotation.nodes = {1, 2};
  rotation.variant = "rotation";
  updating::Location translation = rotation;
  translation.variant = "translation";
  diagnosis.candidates[0].indistinguishable_from = {
      {"added-mass", at_node(201)},
      {"soft-support", rotation},
      {"soft-support", rotation},
      {"soft-support", translation}};
  diagnosis.ladder[0].where = rotation;
  const auto json = diagnosis_json("some/bundle", diagnosis);
  EXPECT_EQ(json.at("candidates").at(0).at("indistinguishable_from").dump(),
            R"([{"effect":"soft-support","where":{"nodes":[1,2]},)"
            R"("variant":"rotation"},)"
            R"({"effect":"soft-support","where":{"nodes":[1,2]},)"
            R"("variant":"translation"}])");
  EXPECT_FALSE(json.at("candidates").at(0).contains("variant"));
  EXPECT_EQ(json.at("ladder").at(0).at("variant"), "rotation");
}

TEST(DiagnoseCommand, JsonIsThatOfTheFormat) {
  const auto json = diagnosis_json("some/bundle", sample_diagnosis());
  EXPECT_EQ(json.at("bundle"), "some/bundle");
  EXPECT_EQ(json.at("verdict"), "added-mass");
  EXPECT_EQ(json.at("error").at("base"), 0.388);
  EXPECT_EQ(json.at("error").at("best"), 0.038);
  EXPECT_EQ(json.at("error").at("floor"), 0.031);
  const auto& candidate = json.at("candidates").at(0);
  EXPECT_EQ(candidate.at("effect"), "added-mass");
  EXPECT_EQ(candidate.at("where").dump(), R"({"node":201})");
  EXPECT_EQ(candidate.at("parameters").dump(),
            R"({"mass_kg":{"value":0.0785,"sd":0.0006,"lo95":0.0773,)"
            R"("hi95":0.0797}})");
  EXPECT_EQ(candidate.at("indistinguishable_from").dump(), "[]");
  EXPECT_EQ(json.at("ladder").at(0).at("added"), "added-mass");
  EXPECT_EQ(json.at("model_parameters").dump(),
            R"({"E:1":{"value":70700000000.0,"sd":200000000.0,)"
            R"("unit":"Pa"}})");
  EXPECT_EQ(json.at("warnings").dump(), "[]");
}

TEST(DiagnoseCommand, NaNIsNeverPrinted) {
  auto diagnosis = sample_diagnosis();
  diagnosis.floor = std::numeric_limits<double>::quiet_NaN();
  const std::string text = diagnosis_json("b", diagnosis).dump();
  EXPECT_EQ(text.find("nan"), std::string::npos);
  EXPECT_NE(text.find(R"("floor":null)"), std::string::npos);
}

TEST(DiagnoseCommand, TextEndsWithTheLadder) {
  const std::string text = diagnosis_text(sample_diagnosis());
  EXPECT_NE(text.find("Diagnosis: added-mass"), std::string::npos) << text;
  EXPECT_NE(text.find("mass 0.07850 ± 0.00060 kg"), std::string::npos) << text;
  EXPECT_LT(text.find("base model"), text.find("+ added-mass")) << text;
  EXPECT_LT(text.find("+ added-mass"), text.rfind("floor")) << text;
}

TEST(LadderText, BarsAreInProportion) {
  updating::Diagnosis diagnosis;
  diagnosis.error_base = 0.3;
  diagnosis.floor = 0.02;
  diagnosis.ladder = {
      {.added = "x", .where = {}, .error = 0.1, .parameters = {}}};
  const std::string text = ladder_text(diagnosis);
  EXPECT_NE(text.find("30.0 %  " + std::string(30, '#') + "\n"),
            std::string::npos)
      << text;
  EXPECT_NE(text.find("10.0 %  " + std::string(10, '#') + "\n"),
            std::string::npos)
      << text;
  EXPECT_NE(text.find("2.0 %  ##\n"), std::string::npos) << text;
}

TEST(EffectOutput, PlacesAreNamedAsTheEffectWantsThem) {
  EXPECT_EQ(where_json("sensor-mass", at_channels({"acc1", "acc2"})).dump(),
            R"({"channels":["acc1","acc2"]})");
  EXPECT_EQ(where_json("channel-gain", at_channels({"acc1"})).dump(),
            R"({"channel":"acc1"})");
  updating::Location line;
  line.nodes = {1, 2, 3};
  EXPECT_EQ(where_json("soft-support", line).dump(), R"({"nodes":[1,2,3]})");
  updating::Location patch;
  patch.elements = {7, 8};
  EXPECT_EQ(where_json("stiffness-loss", patch).dump(),
            R"({"elements":[7,8]})");
  EXPECT_EQ(where_json("damping-law", {}).dump(), "{}");
}

TEST(UpdateCommand, NamedEffectsBecomeRungsAndCandidates) {
  const updating::Rung base{
      .added = "base", .where = {}, .error = 0.5, .parameters = {}};
  const updating::Rung first{
      .added = "sensor-mass", .where = {}, .error = 0.2, .parameters = {}};
  const updating::Rung second{
      .added = "soft-support", .where = {}, .error = 0.05, .parameters = {}};
  updating::Comparison comparison;
  comparison.floor = 0.04;
  const updating::Diagnosis diagnosis =
      updating::diagnosis_of_named({base, first, second}, comparison, {});
  EXPECT_EQ(diagnosis.verdict, "sensor-mass+soft-support");
  EXPECT_EQ(diagnosis.error_base, 0.5);
  EXPECT_EQ(diagnosis.error_best, 0.05);
  EXPECT_EQ(diagnosis.floor, 0.04);
  EXPECT_EQ(diagnosis.ladder.size(), 2U);
  EXPECT_EQ(diagnosis.candidates.size(), 2U);
  EXPECT_EQ(updating::diagnosis_of_named({base}, comparison, {}).verdict,
            "unexplained");
  comparison.floor = 0.4;
  EXPECT_EQ(updating::diagnosis_of_named({base}, comparison, {}).verdict,
            "none");
}

TEST(UpdateCommand, WhatExplainsNothingIsNoVerdict) {
  const updating::Rung base{
      .added = "base", .where = {}, .error = 0.5, .parameters = {}};
  const updating::Rung useless{
      .added = "dashpot", .where = at_node(7), .error = 0.48, .parameters = {}};
  updating::Comparison comparison;
  comparison.floor = 0.04;
  const updating::Diagnosis diagnosis =
      updating::diagnosis_of_named({base, useless}, comparison, {});
  EXPECT_EQ(diagnosis.verdict, "unexplained");
  EXPECT_EQ(diagnosis.candidates.size(), 1U);
  EXPECT_NE(fmt::format("{}", fmt::join(diagnosis.warnings, "\n"))
                .find("dashpot at node 7 does not explain"),
            std::string::npos);
}

TEST(UpdateCommand, CandidatesHaveTheFinalValuesRungsTheirOwn) {
  const auto mass = [](const std::string& name, double value) {
    return updating::Estimate{
        .name = name, .value = value, .sd = 0.1, .lo95 = 0.0, .hi95 = 9.0};
  };
  const updating::Rung base{
      .added = "base", .where = {}, .error = 0.5, .parameters = {}};
  const updating::Rung first{.added = "added-mass",
                             .where = at_node(1),
                             .error = 0.2,
                             .parameters = {mass("mass_kg", 1.0)}};
  updating::Rung second = first;
  second.where = at_node(2);
  second.error = 0.05;
  const auto diagnosis =
      updating::diagnosis_of_named({base, first, second},
                                   {},
                                   {mass("E:1", 7e10),
                                    mass("added-mass mass_kg", 3.0),
                                    mass("added-mass mass_kg", 4.0)});
  EXPECT_EQ(diagnosis.ladder[0].parameters[0].value, 1.0);
  EXPECT_EQ(diagnosis.ladder[0].error, 0.2);
  // Values and error belong together: those with all effects in the model.
  EXPECT_EQ(diagnosis.candidates[0].error, 0.05);
  EXPECT_EQ(diagnosis.candidates[1].error, 0.05);
  EXPECT_EQ(diagnosis.candidates[0].parameters[0].value, 3.0);
  EXPECT_EQ(diagnosis.candidates[1].parameters[0].value, 4.0);
  EXPECT_EQ(diagnosis.candidates[1].parameters[0].name, "mass_kg");
  ASSERT_EQ(diagnosis.model_parameters.size(), 1U);
  EXPECT_EQ(diagnosis.model_parameters[0].name, "E:1");
}

// "0.019 +- 0.023" would say less than the screens do.
TEST(EstimateText, GivesTheEndOfAnIntervalThatHoldsNothing) {
  EXPECT_EQ(estimate_text({"mass_kg", 0.0785, 0.0006, 0.0773, 0.0797}),
            "mass 0.07850 ± 0.00060 kg");
  EXPECT_EQ(estimate_text({"damping_ns_per_m", 0.019, 0.023, 0.0017, 0.2144}),
            "damping at most 0.21 N s/m");
  updating::Estimate stopped{"mass_kg", 1.5e-5, 0.0016, 1.5e-5, 0.0033};
  stopped.at_bound = true;
  EXPECT_EQ(estimate_text(stopped), "mass at most 0.0033 kg");
}

}  // namespace
}  // namespace tapfit::tui
