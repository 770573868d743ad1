#include "tui/app/keep_work.hpp"

#include "tests/tui/support/play.hpp"

#include <gtest/gtest.h>

#include <chrono>
#include <thread>

namespace tapfit::tui {
namespace {

Job saying(const std::string& words) {
  return kept(
      "", [words](Workbench&, Snapshot&, const Progress&) { return words; });
}

TEST(KeepWork, NotesWhetherItFailed) {
  FakeOptions full;
  full.unsaved = "no space is left";
  Snapshot known;
  EXPECT_EQ(saying("added").run(*testing::fake_workbench(full), known, {}),
            "added; no space is left");
  EXPECT_TRUE(known.unsaved);
  EXPECT_EQ(saying("").run(*testing::fake_workbench(full), known, {}),
            "no space is left");
  EXPECT_EQ(saying("added").run(*testing::fake_workbench(), known, {}),
            "added");
  EXPECT_FALSE(known.unsaved);
}

TEST(KeepWork, GoesOnFromWhatAnotherWindowDid) {
  FakeOptions options;
  options.other_window = {{{"sensor-mass", {}}, true}};
  const std::string text = played("5\nwait\na\nwait", {120, 35}, options);
  EXPECT_TRUE(holds(text, "what another window did is taken over; added"))
      << text;
  EXPECT_TRUE(holds(text, "2 effects added")) << text;
  EXPECT_TRUE(holds(text, "sensor-mass")) << text;
}

TEST(KeepWork, LeavingAsksOnceWhereWorkWouldBeLost) {
  FakeOptions full;
  full.unsaved = "no space is left";
  Program program(testing::fake_workbench(full), {});
  (void)replay(program, parse_key_script("5\nwait\na\nwait"));
  program.press(Key(U'q'));
  EXPECT_FALSE(program.quit());
  EXPECT_TRUE(holds(program.draw().to_text(), "q again leaves"));
  // Another key takes the question back.
  program.press(Key(U'j'));
  program.press(Key(U'q'));
  EXPECT_FALSE(program.quit());
  program.press(Key(U'q'));
  EXPECT_TRUE(program.quit());
}

TEST(KeepWork, LeavingAsksNothingWhereAllIsSaved) {
  Program program(testing::fake_workbench(), {});
  (void)replay(program, parse_key_script("5\nwait\na\nwait"));
  program.press(Key(U'q'));
  EXPECT_TRUE(program.quit());
}

/// A program whose fit runs until `held` is cleared, and q pressed meanwhile.
class LeavingDuringAFit : public ::testing::Test {
 protected:
  explicit LeavingDuringAFit(const std::string& add_fails = {})
      : program_(testing::fake_workbench(options(add_fails)), {}) {
    (void)replay(program_, parse_key_script("5\nwait"));
    program_.press(Key(U'a'));
    program_.tick();
    program_.press(Key(U'q'));
  }
  ~LeavingDuringAFit() override { held_ = false; }
  LeavingDuringAFit(const LeavingDuringAFit&) = delete;
  LeavingDuringAFit& operator=(const LeavingDuringAFit&) = delete;

  FakeOptions options(const std::string& add_fails) {
    FakeOptions options;
    options.held = &held_;
    options.add_fails = add_fails;
    return options;
  }
  void end_the_fit() {
    held_ = false;
    wait_until_idle(program_);
  }
  [[nodiscard]] std::string seen() const { return program_.draw().to_text(); }

  std::atomic<bool> held_ = true;
  Program program_;
};

TEST_F(LeavingDuringAFit, WaitsForItsEndAndSaysSo) {
  EXPECT_FALSE(program_.quit());
  EXPECT_TRUE(holds(seen(), "adding added-mass ends first")) << seen();
  EXPECT_TRUE(holds(seen(), "q leaves now, Esc stays")) << seen();
  end_the_fit();
  EXPECT_TRUE(program_.quit());
}

TEST_F(LeavingDuringAFit, LeavesAtOnceWhereAskedAgain) {
  program_.press(Key(U'q'));
  EXPECT_TRUE(program_.quit());
}

TEST_F(LeavingDuringAFit, StaysByEscWithTheFitGoingOn) {
  program_.press(Key(keys::escape));
  for (int i = 0; i < 25; ++i) {  // long enough to be stopped in
    program_.tick();
    std::this_thread::sleep_for(std::chrono::milliseconds(2));
  }
  EXPECT_TRUE(program_.busy());
  end_the_fit();
  EXPECT_FALSE(program_.quit());
  EXPECT_TRUE(holds(seen(), "1 effect added")) << seen();
}

class LeavingDuringAFitThatFails : public LeavingDuringAFit {
 protected:
  LeavingDuringAFitThatFails() : LeavingDuringAFit("it cannot be fitted") {}
};

TEST_F(LeavingDuringAFitThatFails, StaysForTheMessage) {
  end_the_fit();
  EXPECT_FALSE(program_.quit());
  EXPECT_TRUE(holds(seen(), "it cannot be fitted")) << seen();
}

TEST(KeepWork, LeavingByCommandAsksToo) {
  FakeOptions full;
  full.unsaved = "no space is left";
  Program program(testing::fake_workbench(full), {});
  (void)replay(program, parse_key_script("5\nwait\na\nwait\n:q<Enter>"));
  EXPECT_FALSE(program.quit());
  program.press(Key(U'q'));
  EXPECT_TRUE(program.quit());
}

}  // namespace
}  // namespace tapfit::tui
