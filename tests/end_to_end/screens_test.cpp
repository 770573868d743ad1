#include "tests/end_to_end/run_program.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <string>

namespace tapfit::end_to_end {
namespace {

bool holds(const std::string& text, const std::string& part) {
  return text.find(part) != std::string::npos;
}

/// A small virtual test with 50 g hidden at grid 200, and keys played on it.
class SmallTest {
 public:
  SmallTest() {
    const auto made = run_tapfit(fmt::format(
        "simulate '{}' --structure ladder --seed 5 --runs 6 --hits 3 "
        "--effect added-mass@200=0.05",
        bundle().string()));
    EXPECT_EQ(made.exit_status, 0) << made.err;
  }

  [[nodiscard]] std::filesystem::path bundle() const {
    return folder_ / "ladder";
  }
  [[nodiscard]] std::string replay(const std::string& keys) const {
    write_file(folder_ / "keys.txt", keys);
    const auto seen = run_tapfit(fmt::format("'{}' --keys '{}'",
                                             bundle().string(),
                                             (folder_ / "keys.txt").string()));
    EXPECT_EQ(seen.exit_status, 0) << seen.err;
    return seen.out;
  }

 private:
  std::filesystem::path folder_ = fresh_folder();
};

// All seven screens of the program itself.
TEST(Screens, KeysWalkFromRecordingToReport) {
  const SmallTest test;
  std::string script;
  for (const char* key : {"1", "2", "3", "4", "5", "a", "6", "7", "u"}) {
    script += fmt::format("{}\nwait\nscreen\n", key);
  }
  const std::string seen = test.replay(script);
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

// What was undone is done again after the program was left and started anew,
// and the report that a key writes is the one that the command line writes.
TEST(Screens, WorkOutlivesTheProgram) {
  const SmallTest test;
  const std::string undone =
      test.replay("6\nwait\n:add added-mass@200<Enter>\nwait\nu\nwait\n");
  EXPECT_TRUE(holds(undone, "undone")) << undone;
  const std::string redone = test.replay("6\nwait\n<C-r>\nwait\n");
  EXPECT_TRUE(holds(redone, "1 effect added: error")) << redone;
  const std::string there = test.replay("6\nwait\n");
  EXPECT_TRUE(holds(there, "1 effect added: error")) << there;
  EXPECT_TRUE(holds(test.replay("6\nwait\n<C-r>\nwait\n"), "nothing to redo"));

  EXPECT_TRUE(holds(test.replay("7\nwait\nw\nwait\n"), "written: "));
  const std::filesystem::path bundle = test.bundle();
  const auto session = run_tapfit(fmt::format(
      "session '{}' -o '{}'", bundle.string(), (bundle / "r.html").string()));
  ASSERT_EQ(session.exit_status, 0) << session.err;
  EXPECT_TRUE(holds(session.out, "as saved")) << session.out;
  const std::string report = read_file(bundle / "report.html");
  EXPECT_TRUE(holds(report, "+ added mass (node 200)")) << report;
  EXPECT_EQ(report, read_file(bundle / "r.html"));
}

// S as soon as the fit runs, with nothing before it in the queue: it ends with
// its first step.
TEST(Screens, AKeptFitOutlivesTheProgram) {
  const SmallTest test;
  const std::string kept =
      test.replay("6\nwait\n:add added-mass@200\nwait\n<Enter>S\nwait\n");
  EXPECT_TRUE(holds(kept, ", kept early")) << kept;
  const auto headline = [](const std::string& screen) {
    return screen.substr(0, screen.find("kept early")).substr(100);
  };
  const std::string again = test.replay("6\nwait\n");
  EXPECT_EQ(headline(again), headline(kept));
  const std::string redone = test.replay("6\nwait\nu\nwait\n<C-r>\nwait\n");
  EXPECT_EQ(headline(redone), headline(kept));
  EXPECT_TRUE(holds(test.replay("7\nwait\n"), "stopped early, after 1 step"));
  const auto session =
      run_tapfit(fmt::format("session '{}'", test.bundle().string()));
  ASSERT_EQ(session.exit_status, 0) << session.err;
  EXPECT_TRUE(holds(session.out, "stopped early, after 1 step")) << session.out;
  EXPECT_TRUE(holds(session.out, "\nas saved")) << session.out;
  // Added anew it goes on to its end.
  const std::string whole =
      test.replay("6\nwait\nu\nwait\n:add added-mass@200<Enter>\nwait\n");
  EXPECT_FALSE(holds(whole, "kept")) << whole;
}

TEST(Screens, AHitTakenBackIsOverruledAgainAfterARestart) {
  const SmallTest test;
  const std::string back = test.replay("1\nwait\n \nwait\nu\nwait\n");
  EXPECT_TRUE(holds(back, "back to automatic")) << back;
  const std::string again = test.replay("1\nwait\n<C-r>\nwait\n");
  EXPECT_TRUE(holds(again, "run 1, hit 1: overruled again")) << again;
  EXPECT_TRUE(holds(again, "manually")) << again;
}

TEST(Screens, HitsOverruledTogetherAreTakenBackTogetherAfterARestart) {
  const SmallTest test;
  const std::string act = test.replay("1\nwait\ntt \nwait\n");
  EXPECT_TRUE(holds(act, "2 hits overruled")) << act;
  const std::string back = test.replay("1\nwait\nu\nwait\n");
  EXPECT_TRUE(holds(back, "2 hits: back to automatic")) << back;
  const std::string again = test.replay("1\nwait\n<C-r>\nwait\n");
  EXPECT_TRUE(holds(again, "2 hits: overruled again")) << again;
}

}  // namespace
}  // namespace tapfit::end_to_end
