// The command as it is given, on a clamped beam that was measured by its modes.
#include "acquisition/foundation/input_error.hpp"
#include "tests/acquisition/support/temporary_folder.hpp"
#include "tests/tui/support/holds.hpp"
#include "tests/updating/support/clamped_beam.hpp"
#include "tui/commands/commands.hpp"
#include "updating/session/saved_session.hpp"
#include "updating/session/session.hpp"
#include "updating/session/session_file.hpp"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <filesystem>
#include <string>

namespace tapfit::tui {
namespace {

using json = nlohmann::ordered_json;
using tapfit::testing::TemporaryFolder;
namespace beam = updating::testing;

class PredictCommand : public ::testing::Test {
 protected:
  PredictCommand() { write(folder_, 1.0); }

  /// The beam with all its frequencies times that.
  static void write(const TemporaryFolder& folder, double higher) {
    const std::vector<Dof> points = beam::beam_points();
    beam::TrueModes truth = beam::clamped_beam(points);
    for (double& hz : truth.hz) hz *= higher;
    beam::write_modal_bundle(
        folder, beam::beam_text(), truth, points, {0.05, 0.5});
  }

  /// A second test, beside the first one.
  [[nodiscard]] std::filesystem::path tested_after(double higher) const {
    const std::filesystem::path after = folder_.path() / "after";
    std::filesystem::create_directories(after);
    write(folder_, higher);
    for (const char* file : {"test.json", "modes.csv", "model.bdf"}) {
      std::filesystem::copy_file(
          folder_.path() / file,
          after / file,
          std::filesystem::copy_options::overwrite_existing);
    }
    write(folder_, 1.0);
    return after;
  }

  [[nodiscard]] CommandOptions options(const std::string& change) const {
    CommandOptions options;
    options.input = folder_.path();
    options.prediction.changes = {change};
    options.effects = {"none"};
    options.json = true;
    return options;
  }
  static json result(const CommandOptions& options) {
    return json::parse(predict_command(options, {}));
  }
  static std::string fault(const CommandOptions& options) {
    try {
      (void)predict_command(options, {});
    } catch (const InputError& error) {
      return error.what();
    }
    return {};
  }

  TemporaryFolder folder_;
};

TEST_F(PredictCommand, JsonHasThePromisedFields) {
  const json found = result(options("added-mass@21=50g"));
  for (const char* field : {"bundle",
                            "model",
                            "with",
                            "change",
                            "form_sd",
                            "modes",
                            "frfs",
                            "warnings",
                            "against"}) {
    EXPECT_TRUE(found.contains(field)) << field;
  }
  EXPECT_EQ(found.at("change").dump(),
            R"([{"effect":"added-mass","where":{"node":21},)"
            R"("parameters":{"mass_kg":0.05}}])");
  EXPECT_TRUE(found.at("with").empty());
  EXPECT_TRUE(found.at("against").is_null());
  ASSERT_GE(found.at("modes").size(), 5U);
  const json& mode = found.at("modes")[0];
  EXPECT_EQ(mode.at("mode"), 1);
  EXPECT_EQ(mode.at("measured"), 1);
  EXPECT_LT(mode.at("model_after_hz"), mode.at("model_hz"));
  for (const char* field : {"predicted_hz", "change_hz", "change_percent"}) {
    const json& estimate = mode.at(field);
    EXPECT_LE(estimate.at("lo95"), estimate.at("value")) << field;
    EXPECT_GE(estimate.at("hi95"), estimate.at("value")) << field;
    EXPECT_TRUE(estimate.contains("sd")) << field;
  }
  EXPECT_TRUE(mode.at("damping_ratio").contains("hi95"));
}

TEST_F(PredictCommand, TextSaysByWhichModelAndWhatChanges) {
  CommandOptions asked = options("added-mass@21=50g");
  asked.json = false;
  const std::string text = predict_command(asked, {});
  EXPECT_TRUE(holds(text, "added-mass at node 21, mass_kg 0.05")) << text;
  EXPECT_TRUE(holds(text, "no effect (--with none)")) << text;
  EXPECT_TRUE(holds(text, "predicted Hz")) << text;
  EXPECT_FALSE(holds(text, "nan")) << text;
}

TEST_F(PredictCommand, TakesTheEffectsNamedAndThoseKept) {
  CommandOptions asked = options("added-mass@21=50g");
  asked.effects = {"added-mass@11"};
  EXPECT_EQ(result(asked).at("with")[0].at("where").at("node"), 11);
  asked.effects.clear();
  EXPECT_TRUE(holds(result(asked).at("model"), "none is kept"));
  updating::SavedSession saved;
  saved.effects.push_back({{"added-mass", {.node = 9}}, true, false});
  updating::Session session(folder_.path());
  write_saved_session(updating::session_file(session.bundle()), saved);
  const json kept = result(asked);
  EXPECT_TRUE(holds(kept.at("model"), "session.json"));
  ASSERT_EQ(kept.at("with").size(), 1U);
  EXPECT_EQ(kept.at("with")[0].at("where").at("node"), 9);
}

TEST_F(PredictCommand, IsConfirmedOrRefutedByASecondTest) {
  CommandOptions asked = options("added-mass@21=1g");
  const json mode = result(asked).at("modes")[0];
  // Next to nothing was put there: all frequencies fall alike.
  asked.prediction.against =
      tested_after(mode.at("model_after_hz").get<double>() /
                   mode.at("model_hz").get<double>());
  const json right = result(asked).at("against");
  EXPECT_EQ(right.at("finding"), "confirmed") << right.dump();
  EXPECT_EQ(right.at("modes").size(), 5U);
  asked.prediction.against = tested_after(1.2);
  const json wrong = result(asked).at("against");
  EXPECT_EQ(wrong.at("finding"), "refuted") << wrong.dump();
  asked.json = false;
  EXPECT_TRUE(holds(predict_command(asked, {}), "refuted: the worst of 5"));
}

TEST_F(PredictCommand, SaysWhatIsWrong) {
  EXPECT_TRUE(holds(fault(options("added-mass@99=1g")), "no grid 99"));
  EXPECT_TRUE(holds(fault(options("added-mass@21=50kg")), "out of range"));
  EXPECT_TRUE(holds(fault(options("added-mass@21=1,2")), "not 1"));
  EXPECT_TRUE(holds(fault(options("added-mass@21")), "no size"));
  CommandOptions written = options("added-mass@21=1g");
  written.uff = folder_.path() / "out.uff";
  EXPECT_TRUE(holds(fault(written), "it has no FRFs"));
  CommandOptions against = options("added-mass@21=1g");
  against.prediction.against = folder_.path() / "nowhere";
  EXPECT_FALSE(fault(against).empty());
}

}  // namespace
}  // namespace tapfit::tui
