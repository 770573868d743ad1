#include "tests/tui/support/play.hpp"

#include <gtest/gtest.h>

namespace tapfit::tui {
namespace {

TEST(Program, CompletesCommands) {
  EXPECT_TRUE(holds(played(":re"), "Tab: redo  report  retry"))
      << played(":re");
  EXPECT_TRUE(holds(played(":rep<Tab>"), "\n:report"));
  EXPECT_TRUE(holds(played(":ad<Tab>added-m<Tab>"), "\n:add added-mass"));
  EXPECT_TRUE(holds(played("wait\n:run 2<Enter>\nwait"), "run 2 of 2"));
  EXPECT_TRUE(holds(played("wait\n:run x<Enter>"), "which run?"));
  EXPECT_TRUE(
      holds(played("wait\n:report out.md<Enter>\nwait"), "written: out.md"));
  EXPECT_TRUE(
      holds(played("7\nwait\nw\nwait"), "written: made-up/report.html"));
}

TEST(Palette, SaysWhatCommandsDo) {
  for (const Canvas& canvas : {Canvas{80, 24, false}, Canvas{200, 50, true}}) {
    const std::string all = played("1\nwait\n:", canvas);
    EXPECT_TRUE(holds(all, "add EFFECT[@PLACE] ...")) << all;
    EXPECT_TRUE(holds(all, "adds effects to the model")) << all;
    expect_fits(all, canvas.width);
  }
  const std::string some = played("1\nwait\n:re");
  EXPECT_TRUE(holds(some, "tries what failed again")) << some;
  EXPECT_FALSE(holds(some, "writes the updated deck")) << some;
  const std::string one = played("1\nwait\n:drop 1");
  EXPECT_TRUE(holds(one, "takes the mode there out")) << one;
  EXPECT_FALSE(holds(one, "tries what failed again")) << one;
  EXPECT_FALSE(holds(played("1\nwait\n:drop<Esc>"), "takes the mode"));
  EXPECT_TRUE(holds(played("1\nwait\n:"), "... 9 more"));
  EXPECT_FALSE(holds(played("1\nwait\n:", {120, 35, false}), " more"));
}

TEST(Palette, FindsCommandsByTheirLetters) {
  EXPECT_TRUE(holds(played("1\nwait\n:dck"), "writes the updated deck"));
  EXPECT_TRUE(holds(played("1\nwait\n:dck<Tab>"), "\n:deck"));
  // What is only guessed is shown before it is done.
  EXPECT_TRUE(holds(played("1\nwait\n:repot<Enter>"), "\n:report"));
  EXPECT_FALSE(holds(played("1\nwait\n:repot<Enter>\nwait"), "written"));
  EXPECT_TRUE(holds(played("1\nwait\n:tor<Enter><Enter>"), "1 of 7."));
  EXPECT_TRUE(holds(played("1\nwait\n:exp"), "no command is called so"));
  EXPECT_FALSE(holds(played("1\nwait\n:3"), "no command is called so"));
  const std::string unclear = played("1\nwait\n:t<Enter>");
  EXPECT_TRUE(holds(unclear, "write one of :toggle :tour")) << unclear;
  // Of several that hold them Tab takes none.
  EXPECT_TRUE(holds(played("1\nwait\n:ot<Tab>"), "\n:ot "));
  EXPECT_FALSE(holds(played("1\nwait\n:zzz"), "command (Tab"));
}

// By what they do, where no name is near; by a name that is misspelt.
TEST(Palette, FindsCommandsByWhatTheyDo) {
  const std::string writing = played("1\nwait\n:wrte");
  for (const char* does : {"writes the report", "writes FRFs and modes"}) {
    EXPECT_TRUE(holds(writing, does)) << writing;
  }
  EXPECT_FALSE(holds(writing, "no command is called so")) << writing;
  EXPECT_TRUE(holds(played("1\nwait\n:wrte<Enter>", {300, 24}),
                    "did you mean :deck, :plot, :report, :uff?"));
  EXPECT_TRUE(holds(played("1\nwait\n:csv<Tab>"), "\n:plot"));
  EXPECT_TRUE(holds(played("1\nwait\n:reprot<Tab>"), "\n:report"));
}

TEST(Program, TakesALineBackAsAShellDoes) {
  EXPECT_TRUE(holds(played(":add joint<C-u>he"), "\n:he "));
  EXPECT_TRUE(holds(played(":add joint<C-w>dash"), "\n:add dash"));
  EXPECT_TRUE(holds(played(":add  dash"), "Tab: dashpot"))
      << "whatever the number of blanks";
  const std::string filter = played("2\nwait\n/xyz<C-u>4Z");
  EXPECT_TRUE(holds(filter, "\n/4Z")) << filter;
}

TEST(Program, CompletesPlaces) {
  const std::string grids = played("5\nwait\n:add added-mass@");
  EXPECT_TRUE(holds(grids, "Tab: 1  1:rotary  2  2:rotary")) << grids;
  EXPECT_TRUE(holds(played("5\nwait\n:add added-mass@6:<Tab>"),
                    "\n:add added-mass@6:rotary"));
  const std::string channels = played("1\nwait\n:add channel-gain@\nwait");
  EXPECT_TRUE(holds(channels, "acc1  acc2")) << channels;
  EXPECT_TRUE(
      holds(played("1\nwait\n:add channel-gain@a<Tab>"), "channel-gain@acc"));
  EXPECT_TRUE(holds(played("5\nwait\n:add soft-support@r<Tab>"),
                    "soft-support@rotation"));
  // One element after the other.
  const std::string elements = played("5\nwait\n:add stiffness-loss@1:");
  EXPECT_TRUE(holds(elements, "Tab: 1:1  1:2")) << elements;
  // On a screen that needs no model it is read for them.
  EXPECT_TRUE(
      holds(played("1\nwait\n:add joint@\nwait"), "Tab: 1  2  3  4  5  6"));
  EXPECT_FALSE(holds(played("5\nwait\n:add no-such@"), "Tab:"));
}

TEST(Program, TakesLettersOfAnyScript) {
  const std::string typed = played("5\nwait\n:report prüf.md");
  EXPECT_TRUE(holds(typed, "\n:report prüf.md")) << typed;
  EXPECT_TRUE(holds(played("5\nwait\n:prü<BS>f"), "\n:prf"));
  EXPECT_TRUE(holds(played("2\nwait\n/ö<BS>x"), "\n/x"));
}

TEST(Program, RefusesWhatACommandDoesNotTake) {
  const std::string run = played("1\nwait\n:run 99<Enter>");
  EXPECT_TRUE(holds(run, "there is no run 99, of 2")) << run;
  EXPECT_TRUE(holds(run, "run 1 of 2")) << run;
  const std::string undo = played("5\nwait\na\nwait\n:undo 5<Enter>\nwait");
  EXPECT_TRUE(holds(undo, "takes no argument")) << undo;
  EXPECT_TRUE(holds(undo, "1 effect added")) << undo;
}

// What is told while a result is worked out is gone with it.
TEST(Program, NoLongerTellsToWaitOnceItIsThere) {
  Program program(testing::fake_workbench(), {});
  program.press(Key(U'j'));
  const auto seen = [&program] { return program.draw().to_text(); };
  EXPECT_TRUE(holds(seen(), "j has to wait")) << seen();
  wait_until_idle(program);
  EXPECT_FALSE(holds(seen(), "has to wait")) << seen();
}

TEST(Program, WritesWhatThereIsWithoutAModel) {
  FakeOptions options;
  options.model = false;
  const std::string keys = played("7\nwait", {}, options);
  EXPECT_TRUE(holds(keys, "w write report")) << keys;
  EXPECT_FALSE(holds(keys, "write deck")) << keys;
  EXPECT_TRUE(holds(played("7\nwait\nw\nwait", {}, options), "written:"));
  EXPECT_TRUE(holds(played("7\nwait\ne", {}, options), "e does nothing here"));
}

// What does not fit is counted.
TEST(Program, CountsCompletionsThatDoNotFit) {
  const std::string text = played("5\nwait\n:add ");
  EXPECT_TRUE(holds(text, "+")) << text;
  expect_fits(text, 80);
}

TEST(ProgramTyping, SaysWhatWasMeant) {
  // One alone is shown before it is done.
  const std::string seen = played("wait\n:reprot<Enter>", {300, 24});
  EXPECT_TRUE(holds(seen, "\n:report")) << seen;
}

}  // namespace
}  // namespace tapfit::tui
