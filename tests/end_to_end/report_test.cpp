// The written report: the command and the key write the same file, it stands by
// itself, and parameters of rungs on the way are not in it.
#include "tests/end_to_end/run_program.hpp"
#include "tests/end_to_end/small_bundle.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <filesystem>
#include <string>
#include <vector>

namespace tapfit::end_to_end {
namespace {

namespace fs = std::filesystem;

/// The first tag that is not closed as it was opened; empty where all are.
std::string unbalanced_tag(const std::string& html) {
  std::vector<std::string> open;
  for (std::size_t at = html.find('<'); at != std::string::npos;
       at = html.find('<', at + 1)) {
    const std::size_t end = html.find('>', at);
    if (end == std::string::npos) return html.substr(at, 40);
    const std::string tag = html.substr(at + 1, end - at - 1);
    if (tag.starts_with('!') || tag.ends_with('/')) continue;
    const std::string name = tag.substr(0, tag.find_first_of(" \n"));
    if (!name.starts_with('/')) {
      open.push_back(name);
    } else if (open.empty() || "/" + open.back() != name) {
      return tag;
    } else {
      open.pop_back();
    }
  }
  return open.empty() ? "" : open.back();
}

void expect_sound(const std::string& html) {
  EXPECT_EQ(unbalanced_tag(html), "");
  EXPECT_LT(html.size(), 1000000U);
  EXPECT_TRUE(html.starts_with("<!DOCTYPE html>"));
  for (const char* never :
       {">nan", " nan", "-0.00", "+-", "mass_kg", "src=", "href="}) {
    EXPECT_FALSE(holds(html, never)) << never;
  }
}

void play(const fs::path& bundle, const std::string& keys) {
  const fs::path script = bundle.parent_path() / "keys.txt";
  write_file(script, keys);
  const auto seen = run_tapfit(
      fmt::format("'{}' --keys '{}'", bundle.string(), script.string()));
  ASSERT_EQ(seen.exit_status, 0) << seen.err;
}

std::string reported(const fs::path& bundle, const fs::path& file) {
  const auto result = run_tapfit(
      fmt::format("report '{}' -o '{}'", bundle.string(), file.string()));
  EXPECT_EQ(result.exit_status, 0) << result.err;
  EXPECT_EQ(result.out, fmt::format("Report written to {}\n", file.string()));
  return read_file(file);
}

class Report : public WithCache {};

TEST_F(Report, TheCommandAndTheKeyWriteTheSame) {
  const fs::path bundle = copy_of_small_bundle();
  play(bundle, "7\nwait\nw\nwait\n");
  const std::string html = read_file(bundle / "report.html");
  expect_sound(html);
  EXPECT_TRUE(holds(html, "An added mass (node 200) explains where model and"))
      << html.substr(html.find("verdict\">"), 300);
  EXPECT_TRUE(holds(html, "The missing stiffness"));
  EXPECT_EQ(html, reported(bundle, bundle / "other.html"));
  EXPECT_FALSE(fs::exists(bundle / "session.json"));
}

// Added by hand, two effects: the mass changes as the spring comes in.
TEST_F(Report, HoldsFinalValuesOfWhatWasAddedByHand) {
  const fs::path bundle = copy_of_small_bundle();
  play(bundle,
       "6\nwait\n:add dashpot@150<Enter>\nwait\n"
       ":add added-mass@200<Enter>\nwait\n7\nwait\nw\nwait\n");
  const std::string html = read_file(bundle / "report.html");
  expect_sound(html);
  EXPECT_TRUE(holds(html, "With what was added by hand"));
  EXPECT_EQ(html, reported(bundle, bundle / "other.html"));

  const auto saved =
      nlohmann::json::parse(read_file(bundle / "session.json")).at("ladder");
  const std::string markdown = reported(bundle, bundle / "r.md");
  const std::size_t begin = markdown.find("## What was identified");
  const std::string table =
      markdown.substr(begin, markdown.find("## ", begin + 3) - begin);
  const auto value_of = [&](std::size_t rung) {
    const auto& parameters = saved.at(rung).at("parameters");
    return fmt::format("| {:.3g}",
                       parameters.begin()->at("value").get<double>());
  };
  // Base, uncertain properties, dashpot, mass.
  ASSERT_EQ(saved.size(), 4U);
  EXPECT_FALSE(holds(table, value_of(2))) << table;
  EXPECT_TRUE(holds(table, "| added mass \\(node 200\\) | mass |") ||
              holds(table, "| added mass (node 200) | mass |"))
      << table;
  EXPECT_TRUE(fs::exists(bundle / "r-files" / "frf.svg"));
  EXPECT_TRUE(holds(markdown, "(r-files/frf.svg)"));
}

// There are no recordings to be read.
TEST_F(Report, OfReadyFrfsIsWrittenByTheKeyToo) {
  const fs::path bundle = fresh_folder() / "truss";
  fs::copy(fs::path(TAPFIT_SOURCE_DIR) / "recordings" / "paper-truss", bundle);
  play(bundle, "7\nwait\nw\nwait\n");
  const std::string html = read_file(bundle / "report.html");
  expect_sound(html);
  EXPECT_TRUE(holds(html, "E (MAT1 14)"));
  EXPECT_TRUE(holds(html, "FRFs were given ready"));
  EXPECT_EQ(html, reported(bundle, bundle / "other.html"));
}

TEST_F(Report, OfFrequenciesAloneHasNoShapes) {
  const fs::path bundle = fresh_folder() / "frequencies";
  fs::create_directories(bundle);
  write_file(bundle / "modes.csv",
             "frequency_hz,damping_ratio\n39.8,0.014\n251.1,0.015\n");
  write_file(bundle / "test.json", R"({"tapfit": 1, "modes": "modes.csv"})");
  const std::string html = reported(bundle, bundle / "report.html");
  expect_sound(html);
  EXPECT_TRUE(holds(html, "2 modes were given, from 39.80 to 251.1 Hz"));
  EXPECT_FALSE(holds(html, "Mode shapes"));
}

TEST_F(Report, WithoutAModelEndsWithTheModes) {
  const fs::path bundle = copy_of_small_bundle();
  auto test = nlohmann::ordered_json::parse(read_file(bundle / "test.json"));
  test.erase("model");
  test.erase("uncertain");
  test["title"] = "Rig <A> & \"B\"";
  test["operator"] = "A. Ritter";
  write_file(bundle / "test.json", test.dump());
  const std::string html = reported(bundle, bundle / "report.html");
  expect_sound(html);
  EXPECT_TRUE(holds(html, "<h1>Rig &lt;A&gt; &amp; &quot;B&quot;</h1>"));
  EXPECT_TRUE(holds(html, "no model was given"));
  EXPECT_TRUE(holds(html, "A. Ritter"));
}

}  // namespace
}  // namespace tapfit::end_to_end
