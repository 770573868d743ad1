#include "tests/end_to_end/run_program.hpp"
#include "tests/end_to_end/small_bundle.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <string>

namespace tapfit::end_to_end {
namespace {

/// Keys played on the small test.
class Screens : public WithCache {
 protected:
  [[nodiscard]] const std::filesystem::path& bundle() const { return bundle_; }
  [[nodiscard]] std::string replay(const std::string& keys) const {
    const std::filesystem::path script = fresh_folder() / "keys.txt";
    write_file(script, keys);
    const auto seen = run_tapfit(
        fmt::format("'{}' --keys '{}'", bundle_.string(), script.string()));
    EXPECT_EQ(seen.exit_status, 0) << seen.err;
    return seen.out;
  }

 private:
  std::filesystem::path bundle_ = copy_of_small_bundle();
};

// All seven screens of the program itself.
TEST_F(Screens, KeysWalkFromRecordingToReport) {
  std::string script;
  for (const char* key : {"1", "2", "3", "4", "5", "a", "6", "7", "u"}) {
    script += fmt::format("{}\nwait\nscreen\n", key);
  }
  const std::string seen = replay(script);
  for (const char* words : {"run 1 of 6",
                            "|H| [(m/s",
                            "MAC",
                            "measured Hz",
                            "verdict: added-mass",
                            "added-mass at node 200",
                            "Verdict",
                            "undone"}) {
    EXPECT_TRUE(holds(seen, words)) << words;
  }
}

// Neither is it kept nor is what was kept before taken up.
TEST_F(Screens, ATourKeepsNothing) {
  const auto session = bundle() / "session.json";
  const std::filesystem::path script = fresh_folder() / "keys.txt";
  write_file(script, "1\nwait\n<Space>\nwait\n");
  const std::string tour =
      fmt::format("tour '{}' --keys '{}'", bundle().string(), script.string());
  const auto seen = run_tapfit(tour);
  EXPECT_EQ(seen.exit_status, 0) << seen.err;
  EXPECT_TRUE(holds(seen.out, "by hand") || holds(seen.out, "manually"))
      << seen.out;
  EXPECT_FALSE(std::filesystem::exists(session));
}

// What was undone is done again after the program was left and started anew,
// and the report that a key writes is the one that the command line writes.
TEST_F(Screens, WorkOutlivesTheProgram) {
  const std::string undone =
      replay("6\nwait\n:add added-mass@200<Enter>\nwait\nu\nwait\n");
  EXPECT_TRUE(holds(undone, "undone")) << undone;
  const std::string redone = replay("6\nwait\n<C-r>\nwait\n");
  EXPECT_TRUE(holds(redone, "1 effect added: error")) << redone;
  const std::string there = replay("6\nwait\n");
  EXPECT_TRUE(holds(there, "1 effect added: error")) << there;
  EXPECT_TRUE(holds(replay("6\nwait\n<C-r>\nwait\n"), "nothing to redo"));

  EXPECT_TRUE(holds(replay("7\nwait\nw\nwait\n"), "written: "));
  const auto session = run_tapfit(fmt::format("session '{}' -o '{}'",
                                              bundle().string(),
                                              (bundle() / "r.html").string()));
  ASSERT_EQ(session.exit_status, 0) << session.err;
  EXPECT_TRUE(holds(session.out, "as saved")) << session.out;
  const std::string report = read_file(bundle() / "report.html");
  EXPECT_TRUE(holds(report, "+ added mass (node 200)")) << report;
  EXPECT_EQ(report, read_file(bundle() / "r.html"));
}

// S as soon as the fit runs, with nothing before it in the queue: it ends with
// its first step.
TEST_F(Screens, AKeptFitOutlivesTheProgram) {
  const std::string kept =
      replay("6\nwait\n:add added-mass@200\nwait\n<Enter>S\nwait\n");
  EXPECT_TRUE(holds(kept, ", kept early")) << kept;
  const auto headline = [](const std::string& screen) {
    return screen.substr(0, screen.find("kept early")).substr(100);
  };
  const std::string again = replay("6\nwait\n");
  EXPECT_EQ(headline(again), headline(kept));
  const std::string redone = replay("6\nwait\nu\nwait\n<C-r>\nwait\n");
  EXPECT_EQ(headline(redone), headline(kept));
  EXPECT_TRUE(holds(replay("7\nwait\n"), "stopped early, after 1 step"));
  const auto session =
      run_tapfit(fmt::format("session '{}'", bundle().string()));
  ASSERT_EQ(session.exit_status, 0) << session.err;
  EXPECT_TRUE(holds(session.out, "stopped early, after 1 step")) << session.out;
  EXPECT_TRUE(holds(session.out, "\nas saved")) << session.out;
  // Added anew it goes on to its end.
  const std::string whole =
      replay("6\nwait\nu\nwait\n:add added-mass@200<Enter>\nwait\n");
  EXPECT_FALSE(holds(whole, "kept")) << whole;
}

TEST_F(Screens, AHitTakenBackIsOverruledAgainAfterARestart) {
  const std::string back = replay("1\nwait\n \nwait\nu\nwait\n");
  EXPECT_TRUE(holds(back, "back to automatic")) << back;
  const std::string again = replay("1\nwait\n<C-r>\nwait\n");
  EXPECT_TRUE(holds(again, "run 1, hit 1: judged manually again")) << again;
  EXPECT_TRUE(holds(again, "manually")) << again;
}

TEST_F(Screens, HitsOverruledTogetherAreTakenBackTogetherAfterARestart) {
  const std::string act = replay("1\nwait\ntt \nwait\n");
  EXPECT_TRUE(holds(act, "2 hits judged manually")) << act;
  const std::string back = replay("1\nwait\nu\nwait\n");
  EXPECT_TRUE(holds(back, "2 hits: back to automatic")) << back;
  const std::string again = replay("1\nwait\n<C-r>\nwait\n");
  EXPECT_TRUE(holds(again, "2 hits: judged manually again")) << again;
}

}  // namespace
}  // namespace tapfit::end_to_end
