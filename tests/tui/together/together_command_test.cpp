// The command as it is given, on clamped beams that were measured by their
// modes.
#include "tui/together/together_command.hpp"

#include "acquisition/foundation/input_error.hpp"
#include "tests/acquisition/support/temporary_folder.hpp"
#include "tests/updating/support/clamped_beam.hpp"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <cmath>
#include <filesystem>
#include <string>

namespace tapfit::tui {
namespace {

using json = nlohmann::ordered_json;
using tapfit::testing::TemporaryFolder;
namespace beam = updating::testing;

constexpr const char* uncertain =
    R"(, "uncertain": [{"material": 1, "property": "E", "sd_percent": 20}])";

class TogetherCommand : public ::testing::Test {
 protected:
  TogetherCommand() {
    write("a", 1.0, 1, beam::beam_text());
    options_.together.bundles = {folder_.path() / "a", folder_.path() / "b"};
    options_.json = true;
  }

  /// The beam with all its frequencies times that, as the test of that name.
  void write(const char* name,
             double higher,
             unsigned seed,
             const std::string& deck) const {
    const std::vector<Dof> points = beam::beam_points();
    beam::TrueModes truth = beam::clamped_beam(points);
    for (double& hz : truth.hz) hz *= higher;
    beam::write_modal_bundle(
        folder_, deck, truth, points, {0.05, 0.5, seed}, uncertain);
    std::filesystem::create_directories(folder_.path() / name);
    for (const char* file : {"test.json", "modes.csv", "model.bdf"}) {
      std::filesystem::rename(folder_.path() / file,
                              folder_.path() / name / file);
    }
  }

  [[nodiscard]] json result() const {
    return json::parse(together_command(options_, {}));
  }
  [[nodiscard]] std::string refusal() const {
    try {
      static_cast<void>(together_command(options_, {}));
      return "none";
    } catch (const InputError& error) {
      return error.what();
    }
  }

  TemporaryFolder folder_;
  CommandOptions options_;
};

TEST_F(TogetherCommand, OneBeamTwiceHasOneModulus) {
  write("b", 1.0, 2, beam::beam_text());
  const json found = result();
  ASSERT_EQ(found["shared"].size(), 1U);
  const json& e = found["shared"][0];
  EXPECT_EQ(e["parameter"], "E:1");
  EXPECT_NEAR(e["value"], 2.1e11, 2.0 * e["sd"].get<double>());
  EXPECT_EQ(e["alone"].size(), 2U);
  EXPECT_TRUE(found["agree"]);
  EXPECT_GT(e["agreement"]["probability"], 0.01);
}

// 5 % in frequency are 10 % in the modulus.
TEST_F(TogetherCommand, TwoBeamsDoNotAgreeUnlessEachHasItsOwn) {
  write("b", 1.05, 2, beam::beam_text());
  EXPECT_FALSE(result()["agree"]);
  options_.json = false;
  EXPECT_NE(together_command(options_, {}).find("They do NOT agree"),
            std::string::npos);
  options_.json = true;
  options_.together.own = {"E:1"};
  options_.effects = {"added-mass@21"};
  EXPECT_NE(refusal().find("share nothing"), std::string::npos);
}

// Of two decks that call one modulus differently the value is one.
TEST_F(TogetherCommand, DecksMayHaveAnotherValue) {
  std::string deck = beam::beam_text();
  deck.replace(deck.find("2.1+11"), 6, "2.0+11");
  write("b", 1.0, 2, deck);
  const json found = result();
  EXPECT_TRUE(found["agree"]);
  const json& e = found["shared"][0];
  EXPECT_NEAR(e["value"], 2.1e11, 2.0 * e["sd"].get<double>());
  EXPECT_NEAR(e["alone"][1]["value"], 2.1e11, 3e9);
}

TEST_F(TogetherCommand, SaysWhatCannotBeShared) {
  write("b", 1.0, 2, beam::beam_text());
  options_.together.single = {{3, "added-mass@21"}};
  EXPECT_NE(refusal().find("there is no test 3"), std::string::npos);
  options_.together.single = {};
  options_.together.own = {"E:7"};
  EXPECT_NE(refusal().find("no test has an uncertain property E:7"),
            std::string::npos);
  options_.together.own = {};
  options_.together.structures = true;
  EXPECT_NE(refusal().find("share nothing"), std::string::npos);
  options_.together.structures = false;
  options_.together.bundles = {folder_.path() / "a",
                               folder_.path() / "b" / ".." / "a"};
  EXPECT_NE(refusal().find("there twice"), std::string::npos);
}

}  // namespace
}  // namespace tapfit::tui
