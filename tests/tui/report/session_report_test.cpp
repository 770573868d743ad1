// A report of made-up results: what stands in it and what must not.
#include "tui/report/session_report.hpp"

#include "acquisition/foundation/input_error.hpp"
#include "tests/tui/support/fake_results.hpp"
#include "tests/tui/support/holds.hpp"
#include "tests/tui/support/two_effects.hpp"
#include "tui/document/html_document.hpp"
#include "tui/document/markdown_document.hpp"
#include "tui/report/report_parameters.hpp"
#include "tui/report/report_verdict.hpp"
#include "tui/report/report_words.hpp"
#include "tui/report/robustness_output.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <limits>
#include <set>
#include <string>
#include <variant>
#include <vector>

namespace tapfit::tui {
namespace {

using testing::data_of_two_effects;

/// Up to the set-up, which begins the second page.
std::vector<Section> first_page(const Document& document) {
  std::vector<Section> page;
  for (const Section& section : document.sections) {
    if (section.new_page) break;
    page.push_back(section);
  }
  return page;
}

// 66.6 g was the mass before the spring was there.
TEST(IdentifiedRows, AreOfTheLastModelOnly) {
  ReportData data = data_of_two_effects();
  data.bundle.uncertain = {{"material", 1, "E"}};
  data.model->deck.materials[1].E = 7.0e10;
  data.model->deck.shell_properties[1].membrane = 1;
  const auto rows = identified_rows(data.bundle, *data.model);
  ASSERT_EQ(rows.size(), 3U);
  EXPECT_EQ(rows[0].what, "added mass (node 5)");
  EXPECT_EQ(rows[0].quantity, "mass");
  EXPECT_EQ(rows[0].value, "78.50 ± 0.60 g");
  EXPECT_EQ(rows[0].interval, "77.30 … 79.70 g");
  EXPECT_EQ(rows[1].value, "412.0 ± 3.0 N/m");
  EXPECT_EQ(rows[2].what, "E (MAT1 1)");
  EXPECT_EQ(rows[2].quantity, "Young's modulus");
  EXPECT_FALSE(holds(as_html(report_document(data)), "66.6"));
}

// The model is a part of what was diagnosed: hold-out error and next
// measurements are of the whole.
TEST(ReportDocument, TellsNothingOfTheVerdictThatIsNotOfItsModel) {
  ReportData data = data_of_two_effects();
  updating::Diagnosis& d = *data.model->diagnosis;
  d.next = {{{"added-mass", {.node = 5}},
             {"sensor-mass", {.channels = {"acc1"}}},
             {4, 3, 1},
             {6, 3, 1},
             "acc1",
             false,
             0.2,
             0.01}};
  EXPECT_TRUE(is_diagnosed(*data.model));
  EXPECT_TRUE(holds(as_html(report_document(data)), "To separate"));
  EXPECT_TRUE(holds(as_markdown(report_document(data), "f"), "| 4.1 % |"));
  data.model->ladder.pop_back();
  EXPECT_FALSE(is_diagnosed(*data.model));
  EXPECT_EQ(verdict_sentence(data),
            "An added mass (node 5) explains part of where model and "
            "measurement differ: with it, the error of the FRFs falls from "
            "38.8 % to 0.01 %, below what repeatability, mesh and form can "
            "resolve (3.1 %); the diagnosis found a spring to ground (node 6), "
            "too, which is not in this model.");
  const std::string text = as_markdown(report_document(data), "f");
  EXPECT_FALSE(holds(text, "To separate")) << text;
  EXPECT_FALSE(holds(text, "4.1 %")) << text;
}

TEST(ReportDocument, DoesWithFrequenciesAlone) {
  ReportData data = data_of_two_effects();
  data.model.reset();
  data.hits.reset();
  data.frfs = {};
  data.bundle.runs.clear();
  data.bundle.channels.clear();
  data.bundle.modes.emplace();
  data.modes.dofs.clear();
  data.modes.diagram.clear();
  for (modal::Mode& mode : data.modes.modes) mode.shape.resize(0);
  EXPECT_TRUE(verdict_sentence(data).starts_with("3 modes were given, from"));
  const std::string html = as_html(report_document(data));
  EXPECT_TRUE(holds(html, "What was identified"));
  for (const char* none : {"MPC", "poles", "Mode shapes", "AutoMAC"}) {
    EXPECT_FALSE(holds(html, none)) << none;
  }
}

TEST(ReportDocument, DrawsATestAloneOnItsOwnPoints) {
  ReportData data = data_of_two_effects();
  data.model.reset();
  data.bundle.geometry.emplace();
  data.bundle.geometry->nodes = {{4, {0.0, 0.0, 0.0}}, {6, {0.2, 0.1, 0.0}}};
  const Document document = report_document(data);
  std::set<std::string> names;
  for (const Figure& figure : figures_of(document)) names.insert(figure.name);
  EXPECT_TRUE(names.contains("set-up"));
  EXPECT_FALSE(holds(as_html(document), "Order of the points"));
}

TEST(ReportDocument, HasNoTableOfModesWhereThereAreNone) {
  ReportData data = data_of_two_effects();
  data.modes.modes.clear();
  data.model->before.pairs.clear();
  data.model->after.pairs.clear();
  EXPECT_FALSE(holds(as_html(report_document(data)), "Correlation of model"));
}

TEST(ReportDocument, HoldsNoNumberThatIsNone) {
  ReportData data = data_of_two_effects();
  const double none = std::numeric_limits<double>::quiet_NaN();
  data.model->after.model_frfs[0](3) = none;
  data.model->after.frf_band_error(0, 0) = none;
  data.model->after.frf_error[1] = none;
  data.model->before.pairs[0].error_percent =
      std::numeric_limits<double>::infinity();
  data.model->parameters[0].sd = none;
  data.modes.modes[0].frequency_sd_hz = none;
  for (const std::string& text : {as_html(report_document(data)),
                                  as_markdown(report_document(data), "f")}) {
    EXPECT_FALSE(holds(text, "nan"));
    EXPECT_FALSE(holds(text, "-0.00"));
    EXPECT_FALSE(holds(text, "+-"));
    EXPECT_FALSE(holds(text, "_kg"));
  }
}

// What a customer reads of a report is its first page.
TEST(ReportDocument, HoldsOnPageOneAllThatACustomerAsks) {
  ReportData data = data_of_two_effects();
  data.notes.facts = {{"customer", "Orbital"}, {"date", "2026-11-20"}};
  const Document document = report_document(data);
  const std::vector<Section> page = first_page(document);
  ASSERT_EQ(page.size(), 4U);
  EXPECT_EQ(page[1].title, "What was identified");
  EXPECT_EQ(page[2].title, "How sure is it");
  EXPECT_EQ(page[3].title, "What to measure next");
  const Document front{"", "", {page.front()}};
  const std::vector<Figure> pictures = figures_of(front);
  ASSERT_EQ(pictures.size(), 2U);
  EXPECT_EQ(pictures[0].name, "frf");
  EXPECT_EQ(pictures[1].name, "error-ladder");
  EXPECT_TRUE(holds(pictures[1].caption, floor_words(data.model->after)));
  const std::string text = as_markdown(front, "f");
  EXPECT_TRUE(holds(text, "falls from 38.8 % to 0.01 %"));
  EXPECT_TRUE(holds(text, "| modes | customer | date |")) << text;
  EXPECT_TRUE(holds(text, "| Orbital | 2026-11-20 |"));
  EXPECT_TRUE(holds(text, "2 with sensors")) << text;
}

// One sentence in front; a row for each of some twenty changes behind.
TEST(ReportDocument, TellsHowFirmItIsInFrontAndWhyBehind) {
  ReportData data = data_of_two_effects();
  data.model->diagnosis->robustness = testing::fake_robustness();
  const Document document = report_document(data);
  const std::string sentence =
      capitalised(firmness_words(data.model->diagnosis->robustness));
  const Section sure = first_page(document).at(2);
  EXPECT_TRUE(holds(as_html({"", "", {sure}}), sentence));
  const auto firm = std::ranges::find(document.sections,
                                      std::string("How firm the verdict is"),
                                      &Section::title);
  ASSERT_NE(firm, document.sections.end());
  const auto* table = std::get_if<DataTable>(&firm->parts.front());
  ASSERT_NE(table, nullptr);
  EXPECT_EQ(table->rows.size(), 2U);
}

// A forced break leaves the rest of a sheet empty.
TEST(ReportDocument, BeginsANewPageOnceAfterTheFirst) {
  const Document document = report_document(data_of_two_effects());
  EXPECT_EQ(std::ranges::count(document.sections, true, &Section::new_page), 1);
}

// Rejected hits say nothing of what the FRFs are from.
TEST(ReportDocument, TellsTheLargestPeakOfAcceptedHits) {
  ReportData data = data_of_two_effects();
  ASSERT_FALSE(data.hits->runs.at(0).empty());
  acquisition::Hit overload = data.hits->runs[0].front();
  overload.peak_n = 987.6;
  overload.accepted = false;
  overload.reasons = {acquisition::HitFault::Overload};
  data.hits->runs[0].push_back(overload);
  const std::string text = as_markdown(report_document(data), "f");
  const std::size_t rejected = text.find("Rejected hits");
  ASSERT_NE(rejected, std::string::npos);
  EXPECT_FALSE(holds(text.substr(0, rejected), "987.6"));
  EXPECT_TRUE(holds(text.substr(rejected), "987.6"));
}

// A file of ready FRFs need not hold coherences.
TEST(ReportDocument, ShowsNoCoherenceThatWasNotMeasured) {
  ReportData data = data_of_two_effects();
  const auto names_of = [](const ReportData& of) {
    std::set<std::string> names;
    for (const Figure& figure : figures_of(report_document(of))) {
      names.insert(figure.name);
    }
    return names;
  };
  EXPECT_TRUE(names_of(data).contains("coherence"));
  for (signal::Frf& frf : data.frfs.frfs) {
    frf.hits = 0;
    frf.coherence.setOnes();
  }
  EXPECT_FALSE(names_of(data).contains("coherence"));
  EXPECT_TRUE(
      holds(as_markdown(report_document(data), "f"), "| 6Z+ / 3Z+ | – | – |"));
}

TEST(ReportDocument, MarksWhatTheDeckHolds) {
  ReportData data = data_of_two_effects();
  data.model->deck.constraints = {{1, "123456"}, {2, "123456"}, {3, "6"}};
  data.versions = {{"tapfit", "0"}, {"Eigen", "3.4.0"}, {"FFTW", "3.3.10"}};
  const Document document = report_document(data);
  const auto figures = figures_of(document);
  const auto sketch =
      std::ranges::find(figures, std::string("set-up"), &Figure::name);
  ASSERT_NE(sketch, figures.end());
  EXPECT_TRUE(holds(sketch->caption, "Grey: held by the deck."));
  EXPECT_TRUE(holds(as_html(document), "with Eigen 3.4.0 and FFTW 3.3.10."));
}

// One beside the other is read column by column.
TEST(ReportDocument, ShowsTheSameModesBeforeAndAfter) {
  ReportData data = data_of_two_effects();
  updating::Comparison& before = data.model->before;
  before.modes.frequency_hz << 5.0, 36.7, 317.0;
  before.pairs.pop_back();
  const auto figures = figures_of(report_document(data));
  for (const char* name : {"mac-before", "mac-after"}) {
    const auto mac =
        std::ranges::find(figures, std::string(name), &Figure::name);
    ASSERT_NE(mac, figures.end());
    EXPECT_EQ(mac->svg.find("NaN"), std::string::npos);
  }
  const auto cells = [&figures](const char* name) {
    const auto mac =
        std::ranges::find(figures, std::string(name), &Figure::name);
    std::size_t count = 0;
    for (std::size_t at = mac->svg.find("<rect"); at != std::string::npos;
         at = mac->svg.find("<rect", at + 1)) {
      ++count;
    }
    return count;
  };
  EXPECT_EQ(cells("mac-before"), cells("mac-after"));
  const auto mac =
      std::ranges::find(figures, std::string("mac-before"), &Figure::name);
  EXPECT_TRUE(holds(mac->svg, "317.0")) << mac->svg;
  EXPECT_TRUE(holds(mac->svg, "36.70")) << mac->svg;
}

TEST(ReportDocument, SaysWhatTheSketchMarks) {
  const auto figures = figures_of(report_document(data_of_two_effects()));
  const auto sketch =
      std::ranges::find(figures, std::string("set-up"), &Figure::name);
  ASSERT_NE(sketch, figures.end());
  EXPECT_TRUE(
      holds(sketch->caption,
            "Green: added mass (node 5) and spring to ground (node 6)."))
      << sketch->caption;
}

// A channel's mistake is where its sensor was.
TEST(ReportDocument, MarksTheSensorOfAChannelThatIsWrong) {
  ReportData data = data_of_two_effects();
  data.model->ladder.resize(1);
  data.model->ladder.push_back({"channel-gain",
                                {.channels = {"acc1"}},
                                0.01,
                                {{"gain", 1.15, 0.002, 1.146, 1.154}}});
  const auto figures = figures_of(report_document(data));
  const auto sketch =
      std::ranges::find(figures, std::string("set-up"), &Figure::name);
  ASSERT_NE(sketch, figures.end());
  EXPECT_TRUE(holds(sketch->caption, "Green: wrong sensitivity of a channel"))
      << sketch->caption;
  EXPECT_TRUE(holds(sketch->svg, "acc1: found")) << sketch->svg;
}

TEST(ReportDocument, NamesEachPictureOnce) {
  std::set<std::string> names;
  const auto figures = figures_of(report_document(data_of_two_effects()));
  for (const Figure& figure : figures) names.insert(figure.name);
  EXPECT_EQ(names.size(), figures.size());
  for (const char* wanted : {"frf",
                             "error-ladder",
                             "set-up",
                             "coherence",
                             "stabilisation",
                             "mode-1",
                             "mac-before",
                             "mac-after",
                             "error-before",
                             "error-after"}) {
    EXPECT_TRUE(names.contains(wanted)) << wanted;
  }
}

TEST(ReportDocument, ShowsEachEffectsEvidence) {
  ReportData data = data_of_two_effects();
  data.model->ladder[2].added = "stiffness-loss";
  data.model->ladder[2].where = {.elements = {2}};
  data.model->evidence = {
      updating::effect_evidence(data.model->before, data.model->after),
      updating::effect_evidence(data.model->before, data.model->after)};
  const std::string html = as_html(report_document(data));
  EXPECT_TRUE(holds(html, "Evidence for each effect"));
  EXPECT_TRUE(holds(
      html,
      "Loss of stiffness (element 2), in green: error 38.8&#160;% without "
      "it, 0.01&#160;% with it."))
      << html.substr(html.find("Evidence for each"), 400);
  EXPECT_TRUE(holds(html, "where it shows most: error "));
  std::set<std::string> names;
  for (const Figure& figure : figures_of(report_document(data))) {
    names.insert(figure.name);
  }
  for (const char* wanted :
       {"place-1", "with-and-without-1", "place-2", "with-and-without-2"}) {
    EXPECT_TRUE(names.contains(wanted)) << wanted;
  }
}

TEST(IdentifiedRows, TellNothingPerMetreOfOneGrid) {
  ReportData data = data_of_two_effects();
  const updating::Estimate total{
      "rotational_stiffness_nm_per_rad", 523.0, 8.0, 507.0, 539.0};
  updating::Estimate per_m = total;
  per_m.name += "_per_m";
  data.model->ladder[2] = {"joint", {.nodes = {6}}, 0.038, {total, per_m}};
  data.model->parameters.pop_back();
  for (updating::Estimate e : {total, per_m}) {
    e.name = "joint " + e.name;
    data.model->parameters.push_back(e);
  }
  const auto rows = identified_rows(data.bundle, *data.model);
  ASSERT_EQ(rows.size(), 3U);
  EXPECT_EQ(rows[1].quantity, "rotational stiffness");
  EXPECT_EQ(rows[1].value, "523.0 ± 8.0 N·m/rad");
  EXPECT_EQ(rows[2].what, "E:1");
}

TEST(ReportDocument, ShowsASignatureWhereOneGridExplainsMost) {
  ReportData data = data_of_two_effects();
  data.model->signature = testing::fake_signature(5);
  EXPECT_TRUE(holds(as_html(report_document(data)),
                    "Grid 5 alone explains 99.0&#160;% of the misfit; a pure "
                    "mass leaves 6.0&#160;% of it."));
  data.model->signature->absorber = {0.053, 25.0, 0.01, 0.02};
  data.model->ladder.push_back({"absorber", {.node = 5}, 0.03, {}});
  EXPECT_TRUE(holds(as_html(report_document(data)),
                    "an absorber leaves 2.0&#160;% of it."));
  data.model->signature->explained = 0.1;
  EXPECT_FALSE(holds(as_html(report_document(data)), "of the misfit"));
}

}  // namespace
}  // namespace tapfit::tui
