// The Recording screen of the whole program.
#include "tests/tui/support/play.hpp"

#include <gtest/gtest.h>

namespace tapfit::tui {
namespace {

TEST(ProgramRecording, TagsHitsAndActsOnThem) {
  const std::string text = played("wait\ntt \nwait", {120, 35});
  EXPECT_TRUE(holds(text, "2 hits judged manually")) << text;
  EXPECT_TRUE(holds(text, "3 hits, 2 accepted")) << text;  // one out, one in
  EXPECT_TRUE(holds(played("wait\n*", {120, 35}), "3 tagged"));
  EXPECT_FALSE(holds(played("wait\n*T", {120, 35}), "tagged"));
  // The next rejected hit, of this run and then of the next.
  EXPECT_TRUE(holds(played("wait\nN", {120, 35}), "▸2"));
  EXPECT_TRUE(holds(played("wait\nNN", {120, 35}), "run 2 of 2"));
}

// Hit 1 was accepted and hit 2 rejected; both are turned round in one act.
TEST(ProgramRecording, UndoesAndRedoesAnActOnSeveralHitsAsOne) {
  const std::string act = "wait\ntt \nwait\n";
  const std::string undone = played(act + "u\nwait", {120, 35});
  EXPECT_TRUE(holds(undone, "2 hits: back to automatic")) << undone;
  EXPECT_FALSE(holds(undone, "manual")) << undone;
  EXPECT_TRUE(
      holds(played(act + "u\nwait\nu\nwait", {120, 35}), "nothing to undo"));
  const std::string redone = played(act + "u\nwait\n<C-r>\nwait", {120, 35});
  EXPECT_TRUE(holds(redone, "2 hits: judged manually again")) << redone;
  EXPECT_TRUE(holds(redone, "manual")) << redone;
  // And as one again.
  EXPECT_FALSE(holds(played(act + "u\nwait\n<C-r>\nwait\nu\nwait", {120, 35}),
                     "manual"));
}

// Space twice is two acts: the second is taken back first.
TEST(ProgramRecording, UndoesWhatTurnedAHitBack) {
  const std::string text = played("wait\n \nwait\n \nwait\nu\nwait");
  EXPECT_TRUE(holds(text, "#1 rejected manually")) << text;
  const std::string all = played("wait\n \nwait\n \nwait\nu\nwait\nu\nwait");
  EXPECT_TRUE(holds(all, "run 1, hit 1: back to automatic")) << all;
  EXPECT_FALSE(holds(all, "manually")) << all;
}

TEST(ProgramRecording, ActsOnNothingThatIsCovered) {
  const std::string plain = played("wait", {120, 35});
  EXPECT_EQ(played("wait\ni++]\ni", {120, 35}), plain);
  const std::string text = played("wait\ni \nwait", {120, 35});
  EXPECT_TRUE(holds(text, "does nothing here")) << text;
  EXPECT_FALSE(holds(played("wait\ni \nwait\ni", {120, 35}), "manually"));
}

TEST(ProgramRecording, ReadsOutWhatIsUnderTheCursor) {
  EXPECT_FALSE(holds(played("wait", {120, 35}), " s: "));
  const std::string text = played("wait\nl", {120, 35});
  EXPECT_TRUE(holds(text, "hammer 3Z+  ")) << text;
  EXPECT_TRUE(holds(text, " s: ")) << text;
  EXPECT_TRUE(holds(text, " N ")) << text;
}

TEST(ProgramRecording, SaysThatAFilterLeavesNoHit) {
  for (const char* key : {"<Enter>", " ", "t", "j"}) {
    const std::string text =
        played(std::string("wait\n/zz<Enter>\n") + key, {120, 35});
    EXPECT_TRUE(holds(text, "the filter matches nothing")) << key << text;
    EXPECT_TRUE(holds(text, "trigger")) << text;  // not zoomed
  }
}

TEST(ProgramRecording, ReplaysARunAsItCame) {
  Program program(testing::fake_workbench(), {120, 35, false});
  wait_until_idle(program);
  program.press(Key(U'R'));
  EXPECT_TRUE(holds(program.draw().to_text(), "replay 0.0 of 10.0 s"));
  EXPECT_TRUE(holds(program.draw().to_text(), "average: no hit yet"));
  // Ten times as fast, 25 frames a second: 0.4 s a frame. The first block is
  // complete after 246 + 700 samples at 256 Hz = 3.7 s.
  for (int frame = 0; frame < 9; ++frame) program.animate();
  EXPECT_TRUE(holds(program.draw().to_text(), "0 hits"));
  program.animate();
  EXPECT_TRUE(holds(program.draw().to_text(), "1 hits"));
  program.press(Key(U'R'));  // paused
  EXPECT_FALSE(program.animate());
  program.press(Key(U'_'));
  EXPECT_TRUE(holds(program.draw().to_text(), "3 hits, 2 accepted"));
}

TEST(Program, OpensWithoutARunThatCannotBeRead) {
  FakeOptions options;
  options.unreadable = true;
  const std::string first = played("wait", {}, options);
  EXPECT_TRUE(holds(first, "run 2 is left out: run-02.wav: is no sound file"))
      << first;
  EXPECT_TRUE(holds(first, "3 hits, 2 accepted")) << first;
  EXPECT_TRUE(holds(first, "1 of 2 runs left out")) << first;
  const std::string second = played("wait\nn\nwait", {}, options);
  EXPECT_TRUE(holds(second, "run 2 of 2")) << second;
  EXPECT_TRUE(holds(second, "(record it again)")) << second;
  EXPECT_TRUE(holds(played("2\nwait", {}, options), "run 2 is left out"))
      << "whatever the first screen is";
}

TEST(Program, ShowsTheChannelsOfARunWithoutAnyHit) {
  FakeOptions options;
  options.hitless = true;
  const std::string first = played("wait", {}, options);
  EXPECT_TRUE(holds(first, "run 2 is left out: run-02.wav: no hit was found"))
      << first;
  EXPECT_TRUE(holds(first, "1 of 2 runs left out")) << first;
  const std::string second = played("wait\nn\nwait", {}, options);
  EXPECT_TRUE(holds(second, "no hit was found (lower the trigger)")) << second;
  EXPECT_TRUE(holds(second, "hammer [N]")) << second;
  EXPECT_TRUE(holds(second, "acc1 [m/s²]")) << second;
  EXPECT_FALSE(holds(second, "▼")) << second;
}

void take_every_key_on_the_second_run(const FakeOptions& options) {
  Program program(testing::fake_workbench(options), {});
  (void)replay(program, parse_key_script("wait\nn\nwait"));
  for (char32_t code = U' '; code < 0x7F; ++code) {
    if (code == U'q' || code == U'n' || (code >= U'1' && code <= U'7'))
      continue;
    program.press(Key(code));
    program.tick();
    program.animate();
    expect_fits(program.draw().to_text(), 80);
    program.press(Key(keys::escape));
  }
}

TEST(Program, TakesEveryKeyOnARunThatIsLeftOut) {
  FakeOptions options;
  options.unreadable = true;
  take_every_key_on_the_second_run(options);
  options.unreadable = false;
  options.hitless = true;
  take_every_key_on_the_second_run(options);
}

// What lies behind the statements is not acted on, and no key says it would be.
TEST(Program, OffersNothingThatTheStatementsCover) {
  const std::string open = played("wait\ni");
  EXPECT_TRUE(holds(open, "i back to the hits")) << open;
  EXPECT_FALSE(holds(open, "accept/reject")) << open;
  EXPECT_EQ(played("wait\niR<Esc>\nwait"), played("wait\ni<Esc>\nwait"));
  EXPECT_EQ(played("wait\niRi\nwait"), played("wait\nii\nwait"));
}

}  // namespace
}  // namespace tapfit::tui
