// Criteria of correlation against limits: closed forms on made-up pairs.
#include "tui/report/report_criteria.hpp"

#include "tests/tui/support/fake_results.hpp"
#include "tui/document/html_document.hpp"
#include "tui/document/markdown_document.hpp"
#include "tui/report/session_report.hpp"
#include "updating/comparison/criteria.hpp"

#include <gtest/gtest.h>

#include <limits>

namespace tapfit::tui {
namespace {

using updating::Criteria;
using updating::Tally;

bool holds_words(const std::string& text, const std::string& part) {
  return text.find(part) != std::string::npos;
}

/// Three pairs of 5 % and MAC 0.97; their cross-orthogonality is 1, and 0.2
/// between the first measured mode and the last of the model.
updating::Comparison known_pairs() {
  updating::Comparison c = testing::fake_comparison(0.05);
  c.weighted_mac = Eigen::Matrix3d::Identity();
  c.weighted_mac(0, 2) = 0.04;  // 0.2 squared
  return c;
}

/// As delivered 5 % off, now exact.
ReportData two_models() {
  ReportData data;
  data.bundle = testing::fake_bundle();
  data.frfs = testing::fake_frfs();
  data.modes = testing::fake_modes();
  ModelResults model;
  model.deck = testing::fake_deck();
  model.before = known_pairs();
  model.after = testing::fake_comparison(0.0);
  model.after.weighted_mac = Eigen::Matrix3d::Identity();
  model.ladder = {{updating::base_rung, {}, 0.388, {}},
                  {"added-mass", {.node = 5}, 0.038, {}}};
  data.model = std::move(model);
  return data;
}

TEST(Criteria, AreOfEachModeAndTheWorstOfAll) {
  updating::Comparison c = known_pairs();
  c.pairs[1].error_percent = -7.0;
  c.pairs[2].mac = 0.5;
  const std::vector<Criteria> modes = updating::criteria_of(c, 3);
  ASSERT_EQ(modes.size(), 3U);
  EXPECT_DOUBLE_EQ(modes[1].frequency_percent.value(), 7.0);
  EXPECT_DOUBLE_EQ(modes[0].on_diagonal.value(), 1.0);
  EXPECT_DOUBLE_EQ(modes[0].off_diagonal.value(), 0.2);
  EXPECT_DOUBLE_EQ(modes[1].off_diagonal.value(), 0.0);
  const Criteria worst = updating::worst_of(modes);
  EXPECT_TRUE(worst.paired);
  EXPECT_DOUBLE_EQ(worst.frequency_percent.value(), 7.0);
  EXPECT_DOUBLE_EQ(worst.mac.value(), 0.5);
  EXPECT_DOUBLE_EQ(worst.on_diagonal.value(), 1.0);
  EXPECT_DOUBLE_EQ(worst.off_diagonal.value(), 0.2);
}

TEST(Criteria, LetNoModeWithoutAPairPass) {
  const std::vector<Criteria> modes = updating::criteria_of(known_pairs(), 4);
  EXPECT_FALSE(updating::worst_of(modes).paired);
  const acquisition::Limits limits{.frequency_percent = 6.0};
  EXPECT_EQ(updating::keeps(modes[0], limits), true);
  EXPECT_EQ(updating::keeps(modes[3], limits), false);
  const Tally found = updating::tally(modes, limits);
  EXPECT_EQ(found.kept, 3U);
  EXPECT_EQ(found.failed, 1U);
  EXPECT_EQ(found.modes, 4U);
  EXPECT_EQ(found.verdict(), false);
}

TEST(Criteria, JudgeEachLimitThatIsSet) {
  const Criteria mode = updating::criteria_of(known_pairs(), 3).front();
  EXPECT_EQ(updating::keeps(mode, {}), std::nullopt);
  EXPECT_EQ(updating::keeps(mode, {.frequency_percent = 4.9}), false);
  EXPECT_EQ(updating::keeps(mode, {.mac = 0.98}), false);
  EXPECT_EQ(updating::keeps(mode, {.mac = 0.97}), true);
  EXPECT_EQ(updating::keeps(mode, {.cross_orthogonality = 0.1}), false);
  EXPECT_EQ(updating::keeps(mode, {.cross_orthogonality_diagonal = 0.9}), true);
}

TEST(Criteria, AreNotKeptWhereALimitIsNotTested) {
  updating::Comparison c = known_pairs();
  for (updating::ModePair& pair : c.pairs) pair.has_shape = false;
  const Criteria mode = updating::criteria_of(c, 3).front();
  EXPECT_EQ(updating::keeps(mode, {.frequency_percent = 6.0, .mac = 0.9}),
            std::nullopt);
  EXPECT_EQ(updating::keeps(mode, {.frequency_percent = 4.0, .mac = 0.9}),
            false);
  EXPECT_EQ(updating::keeps(mode, {.mac = 0.9}), std::nullopt);
  EXPECT_EQ(updating::keeps(mode, {.frequency_percent = 6.0}), true);
  const Tally found =
      updating::tally({mode}, {.frequency_percent = 6.0, .mac = 0.9});
  EXPECT_EQ(found.kept, 0U);
  EXPECT_EQ(found.verdict(), std::nullopt);
}

TEST(CriteriaTables, SayWhatWasNotTested) {
  ReportData data = two_models();
  data.notes.limits = {.frequency_percent = 2.0, .mac = 0.9};
  for (updating::Comparison* c : {&data.model->before, &data.model->after}) {
    for (updating::ModePair& pair : c->pairs) pair.has_shape = false;
  }
  EXPECT_EQ(criteria_sentence(data),
            "Limits of the test: not tested. Frequency within 2 % is kept by "
            "all 3 measured modes, 0.00 % (mode 1) the worst. MAC at least 0.9 "
            "is not tested. Every limit is kept by 0 of 3, before by 0 of 3.");
  const std::string text = as_markdown(report_document(data), "f");
  EXPECT_TRUE(holds_words(text, "| ≥ 0.9 | – | not tested | – | not tested |"))
      << text;
  EXPECT_TRUE(
      holds_words(text, "| all | 0 of 3 | ✗ fail | 0 of 3 | not tested |"))
      << text;
}

TEST(Criteria, FailWhereANumberIsNone) {
  updating::Comparison c = known_pairs();
  c.pairs[1].mac = std::numeric_limits<double>::quiet_NaN();
  const std::vector<Criteria> modes = updating::criteria_of(c, 3);
  EXPECT_EQ(updating::keeps(modes[1], {.mac = 0.5}), false);
  EXPECT_EQ(updating::keeps(updating::worst_of(modes), {.mac = 0.5}), false);
}

TEST(CriteriaSentence, TellsOfEachLimitByItself) {
  ReportData data = two_models();
  EXPECT_EQ(criteria_sentence(data), "");
  data.notes.limits = {.frequency_percent = 2.0, .mac = 0.9};
  EXPECT_EQ(criteria_sentence(data),
            "Limits of the test: pass. Frequency within 2 % is kept by all 3 "
            "measured modes, 0.00 % (mode 1) the worst. MAC at least 0.9 is "
            "kept by all 3 measured modes, 0.970 (mode 1) the worst. Every "
            "limit is kept by all 3, before by 0 of 3.");
  data.model->after.pairs.pop_back();
  EXPECT_TRUE(holds_words(criteria_sentence(data),
                          "2 of 3 measured modes have a pair. Every limit is "
                          "kept by 2 of 3, before by 0 of 3."))
      << criteria_sentence(data);
}

// Which one fails, and by how much, before those that are kept.
TEST(CriteriaSentence, NamesTheLimitThatIsBrokenFirst) {
  ReportData data = two_models();
  data.notes.limits = {.frequency_percent = 2.0, .cross_orthogonality = 0.1};
  data.model->after.weighted_mac(1, 2) = 0.09;  // 0.3 squared
  EXPECT_TRUE(criteria_sentence(data).starts_with(
      "Limits of the test: fail. Cross-orthogonality off the diagonal at most "
      "0.1 is broken by 1 of 3 measured modes, 0.300 (mode 2) the worst. "
      "Frequency within 2 % is kept by all 3 measured modes"))
      << criteria_sentence(data);
}

TEST(CriteriaTables, PassOrFailBeforeAndAfter) {
  ReportData data = two_models();
  data.notes.limits = {.frequency_percent = 2.0, .mac = 0.98};
  const std::string html = as_html(report_document(data));
  const std::string text = as_markdown(report_document(data), "f");
  EXPECT_TRUE(
      holds_words(text, "| ≤ 2 % | 5.00 % | ✗ fail | 0.00 % | ✓ pass |"))
      << text;
  EXPECT_TRUE(
      holds_words(text, "| ≥ 0.98 | 0.970 | ✗ fail | 0.970 | ✗ fail |"));
  EXPECT_TRUE(holds_words(html, "<td>+5.00 % ✗</td><td>0.970 ✗</td>"));
}

TEST(CriteriaTables, DoWithoutAPair) {
  ReportData data = two_models();
  data.notes.limits = {.frequency_percent = 2.0};
  data.model->before.pairs.clear();
  data.model->after.pairs.clear();
  const std::string text = as_markdown(report_document(data), "f");
  EXPECT_TRUE(holds_words(text, "| 0 of 3 | ✗ fail |"));
  EXPECT_FALSE(holds_words(text, "✓ pass"));
}

// Nothing is judged, so no column says so.
TEST(CriteriaTables, HaveNoColumnsOfLimitsWhereNoneAreSet) {
  const std::string text = as_markdown(report_document(two_models()), "f");
  EXPECT_TRUE(holds_words(text, "| criterion | before | after |")) << text;
  EXPECT_TRUE(holds_words(text, "| mode | measured Hz | before Hz |"));
  EXPECT_FALSE(holds_words(text, "✗"));
}

// Before and after side by side are wider than a sheet with all their limits.
TEST(CriteriaTables, JudgeModesInATableForEachModel) {
  ReportData data = two_models();
  data.notes.limits = {.frequency_percent = 2.0, .mac = 0.9};
  const std::string text = as_markdown(report_document(data), "f");
  for (const char* table :
       {"measurement and model, before",
        "measurement and model, after",
        "| mode | measured Hz | before Hz | error | MAC |",
        "| mode | measured Hz | after Hz | error | MAC |"}) {
    EXPECT_TRUE(holds_words(text, table)) << table;
  }
}

TEST(CriteriaTables, WarnOfALimitThatEveryModelKeeps) {
  ReportData data = two_models();
  data.notes.limits = {.cross_orthogonality = 0.9};
  EXPECT_TRUE(holds_words(as_html(report_document(data)),
                          "A limit of 0.9 off the diagonal is no test"));
  data.notes.limits = {.cross_orthogonality = 0.1};
  EXPECT_FALSE(holds_words(as_html(report_document(data)), "is no test"));
}

}  // namespace
}  // namespace tapfit::tui
