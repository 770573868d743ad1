// The report's sentences on what was found, and how sure it is.
#include "tests/tui/support/fake_results.hpp"
#include "tests/tui/support/holds.hpp"
#include "tests/tui/support/two_effects.hpp"
#include "tui/document/html_document.hpp"
#include "tui/document/markdown_document.hpp"
#include "tui/report/report_verdict.hpp"
#include "tui/report/session_report.hpp"

#include <gtest/gtest.h>

#include <string>
#include <vector>

namespace tapfit::tui {
namespace {

using testing::data_of_two_effects;

/// Up to the set-up, which begins the second page.
std::vector<Section> page_one(const Document& document) {
  std::vector<Section> page;
  for (const Section& section : document.sections) {
    if (section.new_page) break;
    page.push_back(section);
  }
  return page;
}

TEST(VerdictSentence, NamesWhatIsMissingAndTheErrors) {
  const std::string verdict = verdict_sentence(data_of_two_effects());
  EXPECT_EQ(
      verdict,
      "An added mass (node 5) and a spring to ground (node 6) explain where "
      "model and measurement differ: with them, the error of the FRFs "
      "falls from 38.8 % to 0.01 %, below what repeatability, mesh and form "
      "can "
      "resolve (3.1 %).");
}

TEST(VerdictSentence, SaysThatNothingIsMissing) {
  ReportData data = data_of_two_effects();
  data.model->ladder.resize(1);
  data.model->diagnosis->verdict = "none";
  EXPECT_TRUE(verdict_sentence(data).starts_with(
      "Nothing significant is missing from the model"));
}

TEST(VerdictSentence, SaysHowFarAboveItsFloorAnErrorIs) {
  ReportData data = data_of_two_effects();
  data.model->ladder.resize(1);
  data.model->diagnosis->verdict = "none";
  data.model->before.error = data.model->after.error = 0.011;
  data.model->after.floor = 0.0093;
  EXPECT_EQ(verdict_sentence(data),
            "Nothing significant is missing from the model: its FRFs are off "
            "by 1.1 %, 1.2 times what repeatability, mesh and form allow "
            "(0.93 %), as good as the measurement supports.");
}

// Below a floor of 160 % everything is, whatever is missing.
TEST(VerdictSentence, ClaimsNothingBelowAFloorThatHidesErrors) {
  ReportData data = data_of_two_effects();
  data.model->ladder.resize(1);
  data.model->diagnosis->verdict = "none";
  data.model->before.error = data.model->after.error = 1.004;
  data.model->after.floor = data.model->after.floor_noise = 1.604;
  EXPECT_EQ(verdict_sentence(data),
            "Whether anything is missing from the model cannot be told: its "
            "FRFs are off by 100.4 %, and repeatability, mesh and form allow "
            "160.4 %.");
  const std::vector<Section> page = page_one(report_document(data));
  EXPECT_EQ(page.back().title, "What to measure next");
  EXPECT_TRUE(holds(as_markdown({"", "", {page.back()}}, "f"),
                    "- The floor is 160 %, so that only effects"));
}

// Nor above one: what hides, hides.
TEST(VerdictSentence, ClaimsNothingAboveAFloorThatHidesErrors) {
  ReportData data = data_of_two_effects();
  data.model->ladder.resize(1);
  data.model->diagnosis->verdict = "none";
  data.model->before.error = data.model->after.error = 0.726;
  data.model->after.floor = data.model->after.floor_noise = 0.464;
  EXPECT_EQ(verdict_sentence(data),
            "Whether anything is missing from the model cannot be told: its "
            "FRFs are off by 72.6 %, and repeatability, mesh and form allow "
            "46.4 %.");
}

// What fitting the uncertain properties brings is no effect's merit.
TEST(VerdictSentence, GivesAnEffectOnlyItsOwnFall) {
  ReportData data = data_of_two_effects();
  data.model->ladder.pop_back();
  data.model->ladder.insert(data.model->ladder.begin() + 1,
                            {updating::uncertain_rung, {}, 0.0208, {}});
  data.model->before.error = 0.184;
  data.model->after.error = 0.0209;
  data.model->after.floor = 0.02;
  data.model->diagnosis.reset();
  EXPECT_TRUE(verdict_sentence(data).starts_with(
      "With what was added by hand (an added mass (node 5)), the error of the "
      "FRFs stays at 2.1 % (18.4 % as delivered), 1.0 times what"))
      << verdict_sentence(data);
  data.model->after.error = 0.01;
  EXPECT_TRUE(holds(verdict_sentence(data),
                    "falls from 2.1 % (18.4 % as delivered) to 1.0 %"))
      << verdict_sentence(data);
  EXPECT_TRUE(holds(as_html(report_document(data)),
                    "Nothing is proposed: what may be missing has not been "
                    "looked for."));
}

// The modes that were measured do not tell two joints apart.
TEST(VerdictSentence, NamesALookAlike) {
  ReportData data = data_of_two_effects();
  data.model->ladder.pop_back();
  updating::Diagnosis& d = *data.model->diagnosis;
  d.ladder.resize(1);
  d.ladder[0].alike = {{"added-mass", {.node = 6}}};
  EXPECT_TRUE(verdict_sentence(data).starts_with(
      "An added mass (node 5) or an added mass (node 6) explains where"))
      << verdict_sentence(data);
  const std::string points = as_html(report_document(data));
  EXPECT_TRUE(holds(points,
                    "No measurement is known that would separate an "
                    "added mass (node 5) from an added mass (node 6)."));
  EXPECT_TRUE(holds(points, "indistinguishable with these points from"));
  data.bundle.modes.emplace();
  data.modes.dofs.clear();
  for (modal::Mode& mode : data.modes.modes) mode.shape.resize(0);
  data.frfs = {};
  data.hits.reset();
  data.bundle.runs.clear();
  const std::string modes = as_html(report_document(data));
  EXPECT_TRUE(holds(modes,
                    "Measure mode shapes: frequencies alone do not "
                    "separate"));
  EXPECT_TRUE(holds(modes, "indistinguishable with these modes from"));
  EXPECT_FALSE(holds(modes, "easured points."));
  d.ladder[0].alike.push_back({"added-mass", {.node = 4}});
  EXPECT_TRUE(verdict_sentence(data).starts_with(
      "An added mass (node 5) or one of 2 look-alikes explains where"))
      << verdict_sentence(data);
}

TEST(VerdictSentence, SaysWhatNoEffectExplains) {
  ReportData data = data_of_two_effects();
  data.model->ladder.resize(1);
  data.model->after = data.model->before;
  data.model->diagnosis->verdict = "unexplained";
  EXPECT_EQ(verdict_sentence(data),
            "Something is missing from the model that no known effect "
            "explains: its FRFs are off by 38.8 %, 13 times what "
            "repeatability, mesh and form allow (3.1 %).");
}

TEST(VerdictSentence, WithoutAModelCountsModes) {
  ReportData data = data_of_two_effects();
  data.model.reset();
  EXPECT_TRUE(holds(verdict_sentence(data), "no model was given"));
  const std::string html = as_html(report_document(data));
  EXPECT_TRUE(holds(html, "Order of the points"));
  EXPECT_TRUE(holds(html, "AutoMAC"));
  EXPECT_FALSE(holds(html, "Correlation of model"));
}

TEST(VerdictSentence, TellsWhatWasAddedByHand) {
  ReportData data = data_of_two_effects();
  data.model->diagnosis.reset();
  EXPECT_TRUE(verdict_sentence(data).starts_with(
      "With what was added by hand (an added mass (node 5) and"));
}

}  // namespace
}  // namespace tapfit::tui
