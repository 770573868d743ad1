// A challenge played to its end: made, answered rightly, wrongly and not at
// all, revealed.
#include "tui/practice/reveal_command.hpp"

#include "acquisition/foundation/input_error.hpp"
#include "tui/practice/challenge_command.hpp"
#include "updating/session/saved_session.hpp"
#include "updating/session/session.hpp"
#include "updating/virtual_test/truth_seal.hpp"
#include "updating/virtual_test/virtual_bundle.hpp"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <cstdlib>
#include <filesystem>
#include <string>
#include <unistd.h>
#include <vector>

namespace tapfit::tui {
namespace {

namespace fs = std::filesystem;
using nlohmann::json;

/// A plate of six runs with a mass at grid 30, sealed; what is worked out of it
/// is kept from one answer to the next.
class Reveal : public testing::Test {
 protected:
  static void SetUpTestSuite() {
    root_ = fs::path(testing::TempDir()) /
            ("tapfit-reveal-" + std::to_string(::getpid()));
    fs::remove_all(root_);
    ::setenv("XDG_CACHE_HOME", (root_ / "cache").c_str(), 1);
    ::unsetenv("TAPFIT_NO_CACHE");
    updating::VirtualBundleSpec spec;
    spec.structure = "plate";
    spec.effects = {updating::parse_virtual_effect("added-mass@30=0.1")};
    spec.points = 6;
    spec.hits = 2;
    spec.sealed = true;
    updating::make_virtual_bundle(spec, root_ / "test");
  }
  static void TearDownTestSuite() {
    ::unsetenv("XDG_CACHE_HOME");
    ::setenv("TAPFIT_NO_CACHE", "1", 1);
    fs::remove_all(root_);
  }
  static void forget() { fs::remove(root_ / "test" / "session.json"); }

  static CommandOptions options(bool as_json) {
    CommandOptions options;
    options.input = root_ / "test";
    options.json = as_json;
    return options;
  }
  static json revealed() {
    return json::parse(reveal_command(options(true), {}));
  }
  static void play(const std::string& effect, int node) {
    updating::SavedSession session;
    updating::AddedEffect added;
    added.ref.effect = effect;
    added.ref.where.node = node;
    session.effects = {added};
    write_saved_session(root_ / "test" / "session.json", session);
  }

  static void right_answer_is_right();
  static void wrong_answers_are_wrong();
  static void no_answer_yet_is_said();
  static void diagnosis_is_blind_to_the_seal();

  static fs::path root_;
};

fs::path Reveal::root_;

void Reveal::right_answer_is_right() {
  play("added-mass", 30);
  const json all = revealed();
  EXPECT_EQ(all["hidden"][0]["effect"], "added-mass");
  EXPECT_EQ(all["hidden"][0]["node"], 30);
  for (const char* whose : {"session", "diagnosis"}) {
    const json& answer = all[whose];
    EXPECT_EQ(answer["found"], "added-mass") << whose;
    EXPECT_EQ(answer["right_kind"], true) << whose;
    EXPECT_EQ(answer["right_place"], true) << whose;
    EXPECT_EQ(answer["right_size"], true) << whose;
    EXPECT_EQ(answer["effects"][0]["where"]["node"], 30) << whose;
  }
  const std::string text = reveal_command(options(false), {});
  EXPECT_NE(text.find("Hidden: added-mass\n"), std::string::npos) << text;
  EXPECT_NE(text.find("You: added-mass\n"), std::string::npos) << text;
}

void Reveal::wrong_answers_are_wrong() {
  play("ground-spring", 30);
  const json spring = revealed()["session"];
  EXPECT_EQ(spring["found"], "ground-spring");
  EXPECT_EQ(spring["right_kind"], false);
  play("added-mass", 1);  // the corner farthest away
  const json elsewhere = revealed()["session"];
  EXPECT_EQ(elsewhere["right_kind"], true);
  EXPECT_EQ(elsewhere["right_place"], false);
  const std::string text = reveal_command(options(false), {});
  EXPECT_NE(text.find("wrong"), std::string::npos) << text;
}

void Reveal::no_answer_yet_is_said() {
  EXPECT_EQ(revealed()["session"], nullptr);
  const std::string text = reveal_command(options(false), {});
  EXPECT_NE(text.find("no effect is in session.json yet"), std::string::npos)
      << text;
}

// What the diagnosis says follows from the test, not from the seal.
void Reveal::diagnosis_is_blind_to_the_seal() {
  const std::string found = revealed()["diagnosis"]["found"];
  const fs::path bare = root_ / "bare";
  fs::create_directories(bare);
  for (const fs::directory_entry& entry :
       fs::directory_iterator(root_ / "test")) {
    if (entry.path().filename() == updating::seal_file) continue;
    fs::copy(entry.path(), bare / entry.path().filename());
  }
  updating::Session session(bare);
  EXPECT_EQ(session.diagnosis().verdict, found);
  CommandOptions of_bare = options(true);
  of_bare.input = bare;
  EXPECT_THROW((void)reveal_command(of_bare, {}), InputError);
}

// In one process: the diagnosis, which takes seconds, is made once.
TEST_F(Reveal, SetsAnswersBesideTheSeal) {
  no_answer_yet_is_said();
  diagnosis_is_blind_to_the_seal();
  right_answer_is_right();
  forget();
  wrong_answers_are_wrong();
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
