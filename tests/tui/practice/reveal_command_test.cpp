// A challenge played to its end: made, answered and revealed; and how answers
// that are wrong, or none, are told.
#include "tui/practice/reveal_command.hpp"

#include "acquisition/foundation/input_error.hpp"
#include "tui/practice/challenge_command.hpp"
#include "tui/practice/revealed.hpp"
#include "updating/session/saved_session.hpp"
#include "updating/virtual_test/truth_seal.hpp"
#include "updating/virtual_test/virtual_bundle.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <sstream>
#include <string>
#include <unistd.h>
#include <vector>

namespace tapfit::tui {
namespace {

namespace fs = std::filesystem;
using nlohmann::json;

/// A clamped bar, 1 m x 20 mm x 6 mm of steel, that bends in z alone.
std::string bar_deck() {
  constexpr int bars = 8;
  std::string text = "BEGIN BULK\nPARAM,COUPMASS,1\n";
  for (int i = 0; i <= bars; ++i) {
    text += fmt::format("GRID,{},,{},0.,0.,,1246\n", i + 1, double(i) / bars);
  }
  for (int i = 1; i <= bars; ++i) {
    text += fmt::format("CBAR,{},1,{},{},0.,1.,0.\n", i, i, i + 1);
  }
  return text +
         "PBAR,1,1,1.2-4,3.6-10,3.6-10,7.2-10\n"
         "MAT1,1,2.1+11,,.3,7850.\nSPC1,1,123456,1\nENDDATA\n";
}

/// The bar with a mass at grid 7, sealed. Its few modes and places are what
/// makes a diagnosis a matter of a moment.
class Reveal : public testing::Test {
 protected:
  static void SetUpTestSuite() {
    root_ = fs::path(testing::TempDir()) /
            ("tapfit-reveal-" + std::to_string(::getpid()));
    fs::remove_all(root_);
    fs::create_directories(root_);
    ::setenv("XDG_CACHE_HOME", (root_ / "cache").c_str(), 1);
    ::unsetenv("TAPFIT_NO_CACHE");
    std::ofstream(root_ / "bar.bdf") << bar_deck();
    updating::VirtualBundleSpec spec;
    spec.structure = root_ / "bar.bdf";
    spec.band_hz = {2.0, 300.0};
    spec.effects = {updating::parse_virtual_effect("added-mass@7=0.1")};
    spec.points = 5;
    spec.hits = 2;
    spec.sealed = true;
    updating::make_virtual_bundle(spec, root_ / "test");
  }
  static void TearDownTestSuite() {
    ::unsetenv("XDG_CACHE_HOME");
    ::setenv("TAPFIT_NO_CACHE", "1", 1);
    fs::remove_all(root_);
  }

  static CommandOptions options(bool as_json) {
    CommandOptions options;
    options.input = root_ / "test";
    options.json = as_json;
    return options;
  }
  static json revealed() {
    return json::parse(reveal_command(options(true), {}));
  }
  static void play(bool on) {
    updating::SavedSession session;
    updating::AddedEffect added;
    added.ref.effect = "added-mass";
    added.ref.where.node = 7;
    added.on = on;
    session.effects = {added};
    write_saved_session(root_ / "test" / "session.json", session);
  }

  static fs::path root_;
};

fs::path Reveal::root_;

// In one process: the diagnosis is made once.
TEST_F(Reveal, SetsAnswersBesideTheSeal) {
  const std::string text = reveal_command(options(false), {});
  EXPECT_NE(text.find("Hidden: added-mass\n"), std::string::npos) << text;
  EXPECT_NE(text.find("no effect is in session.json yet"), std::string::npos)
      << text;
  play(false);  // switched off it is no answer
  EXPECT_EQ(revealed()["session"], nullptr);
  play(true);
  const json all = revealed();
  EXPECT_EQ(all["hidden"][0]["effect"], "added-mass");
  EXPECT_EQ(all["hidden"][0]["node"], 7);
  for (const char* whose : {"session", "diagnosis"}) {
    const json& answer = all[whose];
    EXPECT_EQ(answer["found"], "added-mass") << whose;
    EXPECT_EQ(answer["right_kind"], true) << whose;
    EXPECT_EQ(answer["right_place"], true) << whose;
    EXPECT_EQ(answer["right_size"], true) << whose;
    EXPECT_EQ(answer["effects"][0]["where"]["node"], 7) << whose;
  }
}

TEST_F(Reveal, WantsASeal) {
  const fs::path bare = root_ / "bare";
  fs::copy(root_ / "test", bare);
  fs::remove(bare / updating::seal_file);
  CommandOptions of_bare = options(true);
  of_bare.input = bare;
  EXPECT_THROW((void)reveal_command(of_bare, {}), InputError);
}

Answer answer_of(const std::string& effect, int node, bool right_kind) {
  Answer answer;
  answer.effects.resize(1);
  answer.effects[0].added = effect;
  answer.effects[0].where.node = node;
  answer.verdict.hidden = "added-mass";
  answer.verdict.found = effect;
  answer.verdict.right_kind = right_kind;
  return answer;
}

Revealed hidden_mass() {
  Revealed it;
  it.truth = nlohmann::ordered_json::parse(
      R"({"seed": 4, "structure": "plate", "effect": "added-mass",
          "effects": [{"effect": "added-mass", "node": 30}]})");
  it.diagnosis = answer_of("added-mass", 30, true);
  return it;
}

/// The line of the table that begins so.
std::string row_of(const std::string& text, const std::string& whose) {
  std::istringstream lines(text);
  std::string line;
  while (std::getline(lines, line)) {
    if (line.starts_with("  " + whose + " ")) return line;
  }
  return {};
}

TEST(Revealed, AnAnswerOfAnotherKindHasNoPlace) {
  Revealed it = hidden_mass();
  it.session = answer_of("ground-spring", 30, false);
  const std::string text = revealed_text("test", it);
  EXPECT_NE(text.find("You: ground-spring\n"), std::string::npos) << text;
  const std::string row = row_of(text, "you");
  EXPECT_NE(row.find("wrong"), std::string::npos) << text;
  EXPECT_EQ(row.find("right"), std::string::npos) << text;
  const json all = revealed_json("test", it);
  EXPECT_EQ(all["session"]["found"], "ground-spring");
  EXPECT_EQ(all["session"]["right_kind"], false);
  EXPECT_EQ(all["diagnosis"]["right_kind"], true);
}

TEST(Revealed, TheRightKindElsewhereIsWrongInItsPlaceAlone) {
  Revealed it = hidden_mass();
  it.session = answer_of("added-mass", 1, true);
  const std::string row = row_of(revealed_text("test", it), "you");
  const std::size_t right = row.find("right");
  ASSERT_NE(right, std::string::npos) << row;
  EXPECT_LT(right, row.find("wrong")) << row;
  EXPECT_EQ(revealed_json("test", it)["session"]["effects"][0]["where"]["node"],
            1);
}

TEST(Revealed, NoAnswerIsRightWhereNothingIsHidden) {
  Revealed it = hidden_mass();
  EXPECT_NE(revealed_text("test", it).find("open it with tapfit test"),
            std::string::npos);
  EXPECT_EQ(row_of(revealed_text("test", it), "you"), "");
  it.truth["effect"] = "none";
  it.truth["effects"] = nlohmann::ordered_json::array();
  EXPECT_NE(revealed_text("test", it).find("none is hidden: right"),
            std::string::npos);
}

TEST(ChallengeCommand, MakesASealedTestAndWritesOverNothing) {
  const fs::path folder = fs::path(testing::TempDir()) / "tapfit-challenge";
  fs::remove_all(folder);
  const std::string name = folder.string();
  const std::vector<const char*> words{
      "challenge", "--seed", "4", "--structure", "plate", "-o", name.c_str()};
  const auto run = [&] {
    return challenge_command(static_cast<int>(words.size()), words.data(), {});
  };
  testing::internal::CaptureStdout();
  EXPECT_EQ(run(), 0);
  const std::string said = testing::internal::GetCapturedStdout();
  EXPECT_NE(said.find("tapfit reveal " + name), std::string::npos) << said;
  EXPECT_FALSE(fs::exists(folder / "truth.json"));
  const auto truth = updating::open_seal(folder);
  EXPECT_EQ(said.find(truth["effect"].get<std::string>()), std::string::npos);
  EXPECT_THROW((void)run(), InputError);
  EXPECT_EQ(updating::open_seal(folder), truth);
  fs::remove_all(folder);
}

TEST(ChallengeCommand, WordsItDoesNotKnowAreStatusTwo) {
  for (const std::vector<const char*>& words :
       std::vector<std::vector<const char*>>{
           {"challenge", "--seed", "4"},
           {"challenge", "-o", "x"},
           {"challenge", "-o", "x", "--seed", "4", "--level", "fair"},
           {"challenge", "-o", "x", "--seed", "4", "--structure", "bridge"}}) {
    testing::internal::CaptureStderr();
    EXPECT_EQ(
        challenge_command(static_cast<int>(words.size()), words.data(), {}), 2);
    EXPECT_NE(testing::internal::GetCapturedStderr(), "");
  }
}

}  // namespace
}  // namespace tapfit::tui
