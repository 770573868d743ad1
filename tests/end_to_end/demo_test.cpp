// The demonstration recording, from hammer taps to the updated model: both
// built-in effects are found, with their sizes, and the error falls to the
// floor. truth.json says what was built in; the program never reads it.
#include "tests/end_to_end/run_program.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <cmath>
#include <fstream>
#include <set>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

namespace tapfit::end_to_end {
namespace {

namespace fs = std::filesystem;
using nlohmann::json;

const fs::path demo = TAPFIT_SOURCE_DIR "/recordings/solar-panel-frame";

std::set<std::string> split(const std::string& text, char separator) {
  std::set<std::string> parts;
  std::stringstream stream(text);
  for (std::string part; std::getline(stream, part, separator);) {
    parts.insert(part);
  }
  return parts;
}

/// The object of truth.json for an effect; null when it was not built in.
json built_in(const json& truth, const std::string& effect) {
  for (const json& object : truth.at("effects")) {
    if (object.at("effect") == effect) return object;
  }
  return nullptr;
}

/// A parameter in the rung that added the effect; 0 when there is none.
double identified(const json& diagnosis,
                  const std::string& effect,
                  const std::string& parameter) {
  double value = 0.0;
  for (const json& rung : diagnosis.at("ladder")) {
    if (rung.at("added") == effect) {
      value = rung.at("parameters").at(parameter).at("value");
    }
  }
  return value;
}

class Demo : public testing::Test {
 protected:
  static void SetUpTestSuite() {
    if (!fs::exists(demo)) return;
    const auto result =
        run_tapfit(fmt::format("run '{}' --json", demo.string()));
    exit_status_ = result.exit_status;
    message_ = result.err;
    if (exit_status_ == 0) run_ = json::parse(result.out);
    truth_ = json::parse(read_file(demo / "truth.json"));
  }
  void SetUp() override {
    if (!fs::exists(demo)) GTEST_SKIP() << demo << " is not there";
    ASSERT_EQ(exit_status_, 0) << message_;
  }

  static inline int exit_status_ = -1;
  static inline std::string message_;
  static inline json run_;
  static inline json truth_;
};

TEST_F(Demo, SomeHitsAreRejectedForDoubleHitAndOverload) {
  std::set<std::string> reasons;
  for (const json& run : run_.at("hits").at("runs")) {
    for (const json& hit : run.at("hits")) {
      for (const json& reason : hit.at("reasons")) reasons.insert(reason);
    }
  }
  EXPECT_TRUE(reasons.contains("double"));
  EXPECT_TRUE(reasons.contains("overload"));
}

// 7056 samples at 256 Hz.
TEST_F(Demo, FrfsSayWhyTheirBlocksAreAsLong) {
  const auto result = run_tapfit(fmt::format("frf '{}' --json", demo.string()));
  ASSERT_EQ(result.exit_status, 0) << result.err;
  const json block = json::parse(result.out).at("block");
  EXPECT_EQ(block.at("samples"), 7056);
  EXPECT_DOUBLE_EQ(block.at("s").get<double>(), 7056.0 / 256.0);
  EXPECT_NE(block.at("reason").get<std::string>().find("spacing"),
            std::string::npos);
}

/// The percentages of the README's error ladder, top to bottom, with the unit
/// of their last digit.
std::vector<std::pair<double, double>> readme_ladder() {
  std::ifstream readme(TAPFIT_SOURCE_DIR "/README.md");
  std::vector<std::pair<double, double>> ladder;
  bool inside = false;
  for (std::string line; std::getline(readme, line);) {
    inside = inside || line.find("error ladder  ") != std::string::npos;
    const std::size_t percent = line.find(" %  #");
    if (!inside || percent == std::string::npos) continue;
    const std::string number =
        line.substr(line.find_last_of(' ', percent - 1) + 1,
                    percent - line.find_last_of(' ', percent - 1) - 1);
    const std::size_t point = number.find('.');
    const auto decimals =
        point == std::string::npos ? 0 : number.size() - point - 1;
    ladder.emplace_back(std::stod(number),
                        std::pow(10.0, -static_cast<double>(decimals)));
    if (line.find("  floor ") != std::string::npos) break;
  }
  return ladder;
}

TEST_F(Demo, TheReadmeShowsItsErrorLadder) {
  const json& diagnosis = run_.at("diagnose");
  std::vector<double> errors = {diagnosis.at("error").at("base"),
                                diagnosis.at("error").at("fitted")};
  for (const json& rung : diagnosis.at("ladder")) {
    errors.push_back(rung.at("error"));
  }
  errors.push_back(diagnosis.at("error").at("floor"));
  const auto shown = readme_ladder();
  ASSERT_EQ(shown.size(), errors.size());
  // Every fit arrives: with E times 1 + 1e-13, 1 - 1e-13 or 1 + 1e-11 every
  // rung is the same to six digits. Rounding, as another processor's
  // instructions make it, turns the last digit shown at most.
  for (std::size_t k = 0; k < errors.size(); ++k) {
    const auto [percent, unit] = shown[k];
    const double share = 0.01;
    EXPECT_NEAR(
        percent, 100.0 * errors[k], std::max(1.1 * unit, share * percent))
        << k;
  }
}

/// What is read in a report beside pictures, numbers left out.
std::string words_of(std::string html) {
  for (const std::string tag : {"svg", "style", "script"}) {
    const std::string close = "</" + tag + ">";
    for (std::size_t at = html.find("<" + tag); at != std::string::npos;
         at = html.find("<" + tag, at)) {
      const std::size_t end = html.find(close, at);
      html.erase(at, end == std::string::npos ? end : end - at + close.size());
    }
  }
  std::string words;
  bool in_tag = false;
  for (const char c : html) {
    in_tag = c == '<' || (in_tag && c != '>');
    const bool letter = (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z');
    if (!in_tag && letter) {
      words += c;
    } else if (!words.empty() && words.back() != ' ') {
      words += ' ';
    }
  }
  return words;
}

// docs/demonstration.html is made by the command that the tutorial names.
TEST_F(Demo, TheReportInTheDocsIsWhatIsWritten) {
  const fs::path written = fresh_folder() / "demonstration.html";
  const auto result = run_tapfit(
      fmt::format("report '{}' -o '{}'", demo.string(), written.string()));
  ASSERT_EQ(result.exit_status, 0) << result.err;
  const std::string shown =
      read_file(TAPFIT_SOURCE_DIR "/docs/demonstration.html");
  EXPECT_LT(shown.size(), 1000000U);
  EXPECT_EQ(words_of(read_file(written)), words_of(shown));
}

/// The demonstration's bundle with another deck in it.
fs::path with_deck(const fs::path& folder, const std::string& deck) {
  fs::create_directories(folder);
  for (const auto& entry : fs::directory_iterator(demo)) {
    if (entry.path().filename() == "session.json") continue;
    fs::copy_file(entry.path(), folder / entry.path().filename());
  }
  write_file(folder / "model.bdf", deck);
  return folder;
}

json three_effects(const fs::path& bundle) {
  const auto result = run_tapfit(fmt::format(
      "update '{}' --effect sensor-mass --effect soft-support --effect "
      "sensor-cable --json",
      bundle.string()));
  EXPECT_EQ(result.exit_status, 0) << result.err;
  return json::parse(result.out);
}

/// Its cards, a line each, from the last to the first.
std::string in_other_order(const std::string& deck) {
  const std::size_t begin = deck.find("BEGIN BULK\n") + 11;
  const std::size_t end = deck.find("ENDDATA");
  std::istringstream lines(deck.substr(begin, end - begin));
  std::string cards;
  for (std::string line; std::getline(lines, line);)
    cards.insert(0, line + "\n");
  return deck.substr(0, begin) + cards + deck.substr(end);
}

/// Every rung within 1 % of itself, what is identified within 0.1 standard
/// deviations.
// To a tenth of a deviation.
void expect_same_values(const json& estimates, const json& others) {
  ASSERT_FALSE(estimates.empty());
  for (const auto& [name, estimate] : estimates.items()) {
    EXPECT_NEAR(estimate.at("value").get<double>(),
                others.at(name).at("value").get<double>(),
                0.1 * estimate.at("sd").get<double>())
        << name;
  }
}

void expect_same_fit(const json& one, const json& other) {
  for (const char* of : {"base", "fitted"}) {
    const double left = one.at("error").at(of);
    EXPECT_NEAR(left, other.at("error").at(of).get<double>(), 1e-3 * left)
        << of;
  }
  ASSERT_EQ(one.at("ladder").size(), 3U);
  ASSERT_EQ(other.at("ladder").size(), 3U);
  ASSERT_EQ(one.at("candidates").size(), 3U);
  ASSERT_EQ(other.at("candidates").size(), 3U);
  for (std::size_t k = 0; k < 3; ++k) {
    const double left = one.at("ladder")[k].at("error");
    EXPECT_NEAR(
        left, other.at("ladder")[k].at("error").get<double>(), 0.01 * left)
        << k;
    expect_same_values(one.at("candidates")[k].at("parameters"),
                       other.at("candidates")[k].at("parameters"));
  }
  expect_same_values(one.at("model_parameters"), other.at("model_parameters"));
}

// Another processor rounds otherwise; so does a modulus that differs in its
// fifteenth digit, and a sum over cards in another order.
TEST_F(Demo, RoundingDoesNotChangeWhatIsIdentified) {
  const std::string deck = read_file(demo / "model.bdf");
  const std::string modulus = "7.0000e+10";
  const std::size_t at = deck.find(modulus);
  ASSERT_NE(at, std::string::npos);
  std::string rounded = deck;
  rounded.replace(at, modulus.size(), "70000000000.007");
  const fs::path folder = fresh_folder();
  const json plain = three_effects(with_deck(folder / "plain", deck));
  expect_same_fit(plain, three_effects(with_deck(folder / "rounded", rounded)));
  expect_same_fit(
      plain, three_effects(with_deck(folder / "other", in_other_order(deck))));
}

// What is missing still is none of the floor, however like a wrong form it
// looks.
TEST_F(Demo, WithOneEffectOfThreeTheErrorIsAboveTheFloor) {
  const auto result = run_tapfit(
      fmt::format("update '{}' --effect sensor-mass --json", demo.string()));
  ASSERT_EQ(result.exit_status, 0) << result.err;
  const json error = json::parse(result.out).at("error");
  // Where the screens begin to ask what else is missing.
  constexpr double near_floor = 1.3;
  EXPECT_GT(error.at("best").get<double>(),
            near_floor * error.at("floor").get<double>());
}

TEST_F(Demo, TheLargeEffectsAreFoundAndNoneInvented) {
  const std::string verdict = run_.at("diagnose").at("verdict");
  const std::set<std::string> found = split(verdict, '+');
  EXPECT_TRUE(found.contains("sensor-mass")) << verdict;
  EXPECT_TRUE(found.contains("soft-support")) << verdict;
  // The cables pull by 1 N/m; a spring or a damper to ground at a sensor is
  // the same to the data, and a pull along the panel may be.
  const std::set<std::string> cable{
      "sensor-cable", "ground-spring", "dashpot", "prestress"};
  for (const std::string& group : found) {
    for (const std::string& effect : split(group, '|')) {
      EXPECT_TRUE(cable.contains(effect) || !built_in(truth_, effect).is_null())
          << effect;
    }
  }
}

// 5 %: what the size of an effect is good for in the lab.
TEST_F(Demo, SensorMassIsWithinFivePercent) {
  const json sensor = built_in(truth_, "sensor-mass");
  ASSERT_FALSE(sensor.is_null());
  const double truth = sensor.at("mass_kg");
  EXPECT_NEAR(identified(run_.at("diagnose"), "sensor-mass", "mass_kg"),
              truth,
              0.05 * truth);
}

TEST_F(Demo, SupportStiffnessIsWithinFivePercent) {
  const json support = built_in(truth_, "soft-support");
  ASSERT_FALSE(support.is_null());
  const double truth = support.at("rotational_stiffness_nm_per_rad");
  EXPECT_NEAR(identified(run_.at("diagnose"),
                         "soft-support",
                         "rotational_stiffness_nm_per_rad"),
              truth,
              0.05 * truth);
}

// 1.5: the two parts of the floor are estimates themselves.
TEST_F(Demo, ErrorFallsToTheFloor) {
  const json& error = run_.at("diagnose").at("error");
  EXPECT_LE(error.at("best").get<double>(),
            1.5 * error.at("floor").get<double>());
  EXPECT_GE(error.at("base").get<double>(),
            3.0 * error.at("best").get<double>());
}

TEST_F(Demo, LadderFallsFromRungToRung) {
  double above = run_.at("diagnose").at("error").at("base");
  for (const json& rung : run_.at("diagnose").at("ladder")) {
    EXPECT_LT(rung.at("error").get<double>(), above) << rung;
    above = rung.at("error");
  }
}

// The text of `update` opens with the paired modes; MAC is its last column.
TEST_F(Demo, MacAfterIsNearOne) {
  const auto result = run_tapfit(fmt::format(
      "update '{}' --effect soft-support --effect sensor-mass", demo.string()));
  ASSERT_EQ(result.exit_status, 0) << result.err;
  std::stringstream lines(result.out);
  std::string line;
  std::getline(lines, line);
  ASSERT_NE(line.find("MAC"), std::string::npos) << result.out;
  int pairs = 0;
  while (std::getline(lines, line) && !line.empty()) {
    EXPECT_GE(std::stod(line.substr(line.find_last_of(' '))), 0.98) << line;
    ++pairs;
  }
  EXPECT_GE(pairs, 3) << result.out;
}

// A test that came as FRFs and a model, without recordings.
TEST_F(Demo, ReadyFrfsAreUpdatedAsRecordingsAre) {
  const fs::path folder = fresh_folder() / "ready-frfs";
  fs::create_directories(folder);
  ASSERT_EQ(run_tapfit(fmt::format("export '{}' --uff '{}'",
                                   demo.string(),
                                   (folder / "frfs.uff").string()))
                .exit_status,
            0);
  fs::copy_file(demo / "model.bdf", folder / "model.bdf");
  std::ifstream file(demo / "test.json");
  json test = json::parse(file);
  test.erase("runs");
  test.erase("channels");
  test["frfs"] = "frfs.uff";
  std::ofstream(folder / "test.json") << test;
  const auto result = run_tapfit(
      fmt::format("update '{}' --effect soft-support --effect sensor-mass "
                  "--effect sensor-cable --json",
                  folder.string()));
  ASSERT_EQ(result.exit_status, 0) << result.err;
  const json found = json::parse(result.out);
  EXPECT_LT(found["error"]["best"].get<double>(), 0.05);
  const json& rungs = found["ladder"];
  ASSERT_EQ(rungs.size(), 3U);
  // Rungs are as they were added: the masses still without the cables, which
  // pull on the modes that tell them.
  ASSERT_EQ(rungs[1]["added"], "sensor-mass");
  EXPECT_NEAR(
      rungs[1]["parameters"]["mass_kg"]["value"].get<double>(), 0.020, 0.002);
  ASSERT_EQ(rungs[2]["added"], "sensor-cable");
  EXPECT_NEAR(
      rungs[2]["parameters"]["stiffness_n_per_m"]["value"].get<double>(),
      0.6,
      0.1);
}

}  // namespace
}  // namespace tapfit::end_to_end
