#include "updating/session/saved_session.hpp"

#include "acquisition/foundation/input_error.hpp"

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>

namespace tapfit::updating {
namespace {

namespace fs = std::filesystem;

class SavedSessionTest : public ::testing::Test {
 protected:
  SavedSessionTest() {
    fs::remove_all(folder_);
    fs::create_directories(folder_);
  }
  ~SavedSessionTest() override {
    std::error_code ignored;
    fs::remove_all(folder_, ignored);
  }
  SavedSessionTest(const SavedSessionTest&) = delete;
  SavedSessionTest& operator=(const SavedSessionTest&) = delete;

  [[nodiscard]] fs::path holding(const std::string& text) const {
    std::ofstream(folder_ / "session.json") << text;
    return folder_ / "session.json";
  }

  fs::path folder_ =
      fs::path(::testing::TempDir()) /
      ::testing::UnitTest::GetInstance()->current_test_info()->name();
};

SavedSession sample() {
  SavedSession session;
  session.title = "Träger";
  session.overruled = {{2, 0}, {0, 4}};
  EffectRef support{"soft-support", {}};
  support.where.nodes = {1, 2, 3};
  support.where.variant = "rotation";
  EffectRef sensors{"sensor-mass", {}};
  sensors.where.channels = {"acc1", "acc2"};
  support.place_sd = {0.25};
  support.start = {1650.0};
  EffectRef loss{"stiffness-loss", {}};
  loss.where.elements = {60, 61};
  using What = modal::PoleEdit::What;
  session.modes.band_hz = {5.0, 60.5};
  session.modes.edits = {{What::Add, 20.0}, {What::Drop, 12.98}};
  session.modes.pairs = {{7.232, 2}, {13.0, -1}};
  session.effects = {{support, true}, {sensors, false}, {loss, true}};
  session.restored = {{1, 2}, {1, 3, true}};
  EffectRef moved{"point-mislabelled", {}};
  moved.where.channels = {"acc1"};
  moved.where.nodes = {8};
  moved.where.node = 6;
  moved.where.runs = {2, 3};
  session.undone = {{{}, 2}, {{support}, {}}, {{moved}, {}}};
  session.kept = {{{support, loss}, 7}, {{}, 1}};
  SavedRung rung;
  rung.rung.added = "soft-support";
  rung.rung.where = support.where;
  rung.rung.error = 0.1 + 0.2;  // no short decimal fraction
  rung.rung.parameters = {{"stiffness_nm_per_rad", 1650.0, 20.0, 1610, 1690}};
  ModePair pair;
  pair.measured = 1;
  pair.model = 2;
  pair.measured_hz = 7.232;
  pair.model_hz = 7.3;
  pair.error_percent = 0.94;
  pair.mac = 0.998;
  rung.modes = {pair};
  session.ladder = {rung};
  return session;
}

TEST_F(SavedSessionTest, IsReadAsItWasWritten) {
  const fs::path file = folder_ / "session.json";
  const SavedSession session = sample();
  write_saved_session(file, session);
  write_saved_session(file, session);  // over one that is there
  const SavedSession read = read_saved_session(file);
  EXPECT_EQ(read.title, session.title);
  EXPECT_EQ(read.overruled, session.overruled);
  EXPECT_EQ(read.modes, session.modes);
  EXPECT_EQ(read.restored, session.restored);
  EXPECT_EQ(read.effects, session.effects);
  EXPECT_EQ(read.effects.at(0).ref.place_sd, std::vector{0.25});
  EXPECT_EQ(read.effects.at(0).ref.start, std::vector{1650.0});
  EXPECT_EQ(read.undone, session.undone);
  EXPECT_EQ(read.kept, session.kept);
  // Numbers to the last bit, the text says so.
  EXPECT_EQ(as_text(read), as_text(session));
  EXPECT_EQ(read.ladder.at(0).rung.error, session.ladder[0].rung.error);
  EXPECT_EQ(std::distance(fs::directory_iterator(folder_), {}), 1)
      << "nothing else is left behind";
}

TEST_F(SavedSessionTest, CountsRunsAndHitsFromOneInTheFile) {
  EXPECT_NE(as_text(sample()).find("\"run\": 3,\n      \"hit\": 1"),
            std::string::npos);
}

TEST_F(SavedSessionTest, KeepsWhatWasAddedTogether) {
  Location where;
  where.node = 5;
  const EffectRef mass{"added-mass", where};
  const EffectRef spring{"ground-spring", where};
  SavedSession session;
  session.effects = with_added({}, {mass, spring});
  session.undone = {{{spring, mass}, {}}};
  const SavedSession read = read_saved_session(holding(as_text(session)));
  EXPECT_EQ(read.effects, session.effects);
  EXPECT_EQ(read.undone, session.undone);
}

// As versions before kept fits wrote it, with whole places in "undone".
TEST_F(SavedSessionTest, ReadsFilesOfEarlierVersions) {
  const SavedSession read = read_saved_session(holding(
      R"({"tapfit_session": 1, "title": "", "overruled_hits": [],
          "modes": {"edits": [], "pairs": []}, "effects": [], "ladder": [],
          "undone": [{"switched": 2},
                     {"effect": "added-mass", "node": 5, "nodes": [],
                      "elements": [], "channels": [], "variant": ""}]})"));
  Location where;
  where.node = 5;
  EXPECT_EQ(
      read.undone,
      (std::vector<EffectChange>{{{}, 1}, {{{"added-mass", where}}, {}}}));
  EXPECT_TRUE(read.kept.empty());
  EXPECT_TRUE(read.restored.empty());
}

TEST_F(SavedSessionTest, RefusesWhatIsNoSession) {
  for (const char* text :
       {"",
        "{",
        "[]",
        "{}",
        R"({"tapfit_session": 2, "overruled_hits": [], "effects": []})",
        R"({"tapfit_session": 1, "effects": {}})",
        R"({"tapfit_session": 1, "effect": []})",
        R"({"tapfit_session": 1, "undone": 3})",
        R"({"tapfit_session": 1, "undone": [{"effect": 1}]})",
        R"({"tapfit_session": 1, "undone": [{"switched": 0}]})",
        R"({"tapfit_session": 1, "kept_fits": [{"effects": []}]})",
        R"({"tapfit_session": 1, "kept_fits": [{"steps": 0}]})",
        R"({"tapfit_session": 1, "restored_hits": [{"run": 1}]})",
        R"({"tapfit_session": 1, "effects": [{"effect": "dashpot",
            "grid": 5}]})",
        R"({"tapfit_session": 1, "overruled_hits": [{"run": 0, "hit": 1}],
            "effects": []})",
        R"({"tapfit_session": 1, "overruled_hits": [], "effects": [],
            "modes": {"edits": [{"take_hz": 5}]}})",
        R"({"tapfit_session": 1, "overruled_hits": [], "effects": [],
            "modes": {"pairs": [{"measured_hz": 5, "model": 0}]}})",
        R"({"tapfit_session": 1, "overruled_hits": [], "effects": [],
            "modes": {"band_hz": [5]}})",
        R"({"tapfit_session": 1, "undone": [{"switched": 1e300}]})",
        R"({"tapfit_session": 1, "modes": {"pairs":
            [{"measured_hz": 5, "model": 1.5}]}})",
        R"({"tapfit_session": 1, "ladder": [{"added": "joint", "where": {},
            "error": 0.1, "parameters": {}, "modes": [{"measured":
            -2147483648, "model": 1, "measured_hz": 5, "model_hz": 5,
            "error_percent": 0, "mac": null}]}]})",
        R"({"tapfit_session": 1, "overruled_hits": [],
            "effects": [{"where": {}}]})",
        R"({"tapfit_session": 1, "overruled_hits": [],
            "effects": [{"effect": "added-mass", "where": {"node": "x"}}]})"}) {
    EXPECT_THROW((void)read_saved_session(holding(text)), InputError) << text;
  }
  EXPECT_THROW((void)read_saved_session(folder_ / "none.json"), InputError);
}

TEST_F(SavedSessionTest, SaysWhereInTheFile) {
  const auto told = [&](const char* text) -> std::string {
    try {
      (void)read_saved_session(holding(text));
    } catch (const InputError& error) {
      return error.what();
    }
    return {};
  };
  const std::string type = told(
      R"({"tapfit_session": 1,
          "effects": [{"effect": "dashpot", "on": "no"}]})");
  EXPECT_NE(type.find("/effects/0/on"), std::string::npos) << type;
  EXPECT_EQ(type.find("json.exception"), std::string::npos) << type;
  const std::string field = told(
      R"({"tapfit_session": 1,
          "effects": [{"effect": "dashpot", "where": {"grid": 5}}]})");
  EXPECT_NE(field.find("\"where\" has no field \"grid\""), std::string::npos)
      << field;
}

TEST_F(SavedSessionTest, SaysWhereItCannotBeWritten) {
  EXPECT_THROW(write_saved_session(folder_ / "no" / "session.json", sample()),
               InputError);
}

}  // namespace
}  // namespace tapfit::updating
