// What a report says of who tested when and with what.
#include "tui/report/report_traceability.hpp"

#include "tests/tui/support/fake_results.hpp"
#include "tui/document/html_document.hpp"

#include <gtest/gtest.h>

namespace tapfit::tui {
namespace {

ReportData test_of(const std::string& date) {
  ReportData data;
  data.bundle = testing::fake_bundle();
  data.notes.facts = {{"date", date},
                      {"operator", "A. Ritter"},
                      {"hammer tip", "nylon"},
                      {"temperature", "21 °C"}};
  for (const acquisition::Channel& channel : data.bundle.channels) {
    data.notes.channels[channel.name] = {
        "", "SN <4711>", "2026-03-01", "2027-03", {}};
  }
  return data;
}

std::string printed(const ReportData& data) {
  Document document;
  document.sections = {{"Set-up", traceability_parts(data), false}};
  return as_html(document);
}

TEST(Traceability, PrintsChannels) {
  ReportData data = test_of("2026-11-20");
  data.notes.channels.begin()->second.others = {{"cable", "2 m"}};
  const std::string html = printed(data);
  for (const char* part :
       {"SN &lt;4711&gt;", "2026-03-01", "2027-03", "cable 2 m"}) {
    EXPECT_NE(html.find(part), std::string::npos) << part;
  }
  EXPECT_EQ(html.find(">type<"), std::string::npos) << "no channel has one";
}

TEST(Traceability, HasNoRemarkWhereAllIsTold) {
  EXPECT_TRUE(traceability_remarks(test_of("2026-11-20")).empty());
  EXPECT_TRUE(traceability_remarks(test_of("2027-03-31")).empty())
      << "due in that month";
}

TEST(Traceability, SaysWhichCalibrationHadRunOut) {
  const ReportData data = test_of("2027-04-01");
  const std::vector<std::string> remarks = traceability_remarks(data);
  ASSERT_EQ(remarks.size(), data.bundle.channels.size());
  EXPECT_EQ(remarks.front(),
            "The calibration of " + data.bundle.channels.front().name +
                " was due on 2027-03, before the test of 2027-04-01.");
}

TEST(Traceability, SaysWhichCalibrationCameAfterTheTest) {
  const std::vector<std::string> remarks =
      traceability_remarks(test_of("2026-02-11"));
  ASSERT_FALSE(remarks.empty());
  EXPECT_TRUE(remarks.front().ends_with(
      " was calibrated on 2026-03-01, after the test of 2026-02-11."));
}

TEST(Traceability, ComparesNoDatesWrittenOtherwise) {
  EXPECT_TRUE(traceability_remarks(test_of("11 Feb 2026")).empty());
}

TEST(Traceability, SaysWhatIsMissing) {
  ReportData data = test_of("2026-11-20");
  const std::string first = data.bundle.channels.front().name;
  data.notes.channels[first].serial.clear();
  data.notes.facts.erase(data.notes.facts.begin() + 1);
  const std::vector<std::string> remarks = traceability_remarks(data);
  ASSERT_EQ(remarks.size(), 1U);
  EXPECT_EQ(
      remarks[0],
      "To make the test traceable, test.json lacks: operator; serial of " +
          first + ".");
  data.notes.channels.clear();
  EXPECT_TRUE(traceability_remarks(data)[0].ends_with(
      "serial of the channels; calibrated of the channels."));
}

TEST(Traceability, AsksNothingOfTheHammerWhereFrfsWereGiven) {
  ReportData data;
  EXPECT_EQ(
      traceability_remarks(data),
      std::vector<std::string>{
          "To make the test traceable, test.json lacks: date; operator."});
}

}  // namespace
}  // namespace tapfit::tui
