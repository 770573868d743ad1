#include "tests/tui/support/play.hpp"

#include <gtest/gtest.h>

#include <sstream>

namespace tapfit::tui {
namespace {

// What was found stays to be read until something else is.
TEST(Program, KeepsTheLastListWhileItLooksAnew) {
  FakeOptions options;
  options.endless_diagnosis = true;
  Program program(testing::fake_workbench(options), {});
  (void)replay(program, parse_key_script("5\nwait\na\nwait\n"));
  program.press(Key(U'5'));
  const auto seen = [&program] { return program.draw().to_text(); };
  for (int i = 0; i < 20000 && !holds(seen(), "43 %"); ++i) program.tick();
  EXPECT_TRUE(holds(seen(), "hypotheses … 43 %")) << seen();
  EXPECT_TRUE(holds(seen(), "verdict: added-mass")) << seen();
  EXPECT_TRUE(holds(seen(), "outdated, diagnosing again")) << seen();
  // It may be read, but what it proposes is not added.
  program.press(Key(U'j'));
  EXPECT_TRUE(holds(seen(), "▸    1.7 %")) << seen();
  program.press(Key(U'a'));
  EXPECT_TRUE(holds(seen(), "found before the last change")) << seen();
  program.press(Key(keys::escape));
  wait_until_idle(program);
  EXPECT_TRUE(holds(seen(), "outdated, diagnosing again")) << seen();
}

TEST(Program, DiagnosesWhileOtherScreensAreRead) {
  Program program(testing::fake_workbench({}), {});
  program.press(Key(U'3'));
  wait_until_idle(program);
  program.press(Key(U'5'));
  const std::string at_once = program.draw().to_text();
  EXPECT_TRUE(holds(at_once, "verdict: ")) << at_once;
}

TEST(Program, PutsADiagnosisOffForWhatAScreenWaitsFor) {
  FakeOptions options;
  options.endless_first_diagnosis = true;
  Program program(testing::fake_workbench(options), {});
  const auto seen = [&program] { return program.draw().to_text(); };
  const auto comes = [&](const char* words) {
    for (int i = 0; i < 20000 && !holds(seen(), words); ++i) program.tick();
    return holds(seen(), words);
  };
  program.press(Key(U'3'));
  ASSERT_TRUE(comes("diagnosis: ")) << seen();
  program.press(Key(U'4'));
  EXPECT_TRUE(comes("MAC")) << seen();
  EXPECT_TRUE(comes("diagnosis: ")) << "goes on after it: " << seen();
  program.leave();
}

/// A diagnosis that has tried two and goes on.
class Trying : public ::testing::Test {
 protected:
  Trying() {
    program_.press(Key(U'5'));
    for (int i = 0; i < 20000 && !holds(seen(), "2 tried"); ++i) {
      program_.tick();
    }
  }
  [[nodiscard]] std::string seen() const { return program_.draw().to_text(); }
  [[nodiscard]] static FakeOptions endless() {
    FakeOptions options;
    options.endless_first_diagnosis = true;
    return options;
  }
  Program program_{testing::fake_workbench(endless()), {}};
};

// What is fitted first is listed at once, and stays when it is stopped.
TEST_F(Trying, IsListedBeforeThereIsAVerdict) {
  ASSERT_TRUE(holds(seen(), "2 tried")) << seen();
  EXPECT_TRUE(holds(seen(), "no verdict yet   2 tried, the best leaves"))
      << seen();
  EXPECT_FALSE(holds(seen(), "uniquely identified")) << seen();
  for (const char32_t key : {U'A', U'R'}) {
    program_.press(Key(key));
    EXPECT_TRUE(holds(seen(), "no verdict yet: a adds")) << seen();
  }
  program_.press(Key(keys::escape));
  wait_until_idle(program_);
  EXPECT_TRUE(holds(seen(), "no verdict yet   2 tried")) << seen();
  program_.press(Key(U'a'));
  wait_until_idle(program_);
  EXPECT_TRUE(holds(seen(), "added-mass")) << seen();
  EXPECT_FALSE(holds(seen(), "no verdict yet")) << seen();
}

// It may be added while the diagnosis still runs, which then is out of date.
TEST_F(Trying, CanBeAddedWithoutWaiting) {
  ASSERT_TRUE(holds(seen(), "2 tried")) << seen();
  program_.press(Key(U'a'));
  wait_until_idle(program_);
  program_.press(Key(U'5'));
  wait_until_idle(program_);
  EXPECT_TRUE(holds(seen(), "verdict: added-mass")) << seen();
}

// Worked out in the background, in place of table and plots until Esc.
TEST(Program, TellsHowFirmTheVerdictIs) {
  Program program(testing::fake_workbench({}), {});
  (void)replay(program, parse_key_script("5\nwait\n"));
  const auto seen = [&program] { return program.draw().to_text(); };
  program.press(Key(U'R'));
  EXPECT_TRUE(holds(seen(), "how firm the verdict is")) << seen();
  wait_until_idle(program);
  EXPECT_TRUE(holds(seen(), "stands under 1 of 2 changes")) << seen();
  EXPECT_TRUE(holds(seen(), "runs 1 to 2 left out  none")) << seen();
  EXPECT_FALSE(holds(seen(), "sensor-mass")) << seen();
  program.press(Key(keys::escape));
  EXPECT_TRUE(holds(seen(), "sensor-mass")) << seen();
}

TEST(Program, ReportsWhatAnEarlierRunFoundMissing) {
  const auto report = [](bool before) {
    FakeOptions options;
    options.diagnosed_before = before;
    Program program(testing::fake_workbench(options), {});
    (void)replay(program, parse_key_script("7\nwait\n"));
    return program.draw().to_text();
  };
  EXPECT_TRUE(holds(report(false), "not diagnosed yet")) << report(false);
  EXPECT_FALSE(holds(report(true), "not diagnosed yet")) << report(true);
  EXPECT_TRUE(holds(report(true), "added-mass")) << report(true);
}

// The message is of what ran then.
TEST(Program, WhatWasToBeWaitedForIsNoLongerToldOnceItIsThere) {
  std::atomic<bool> held = true;
  FakeOptions options;
  options.diagnosis_held = &held;
  Program program(testing::fake_workbench(options), {});
  (void)replay(program, parse_key_script("5\nwait\na\nwait\n"));
  program.press(Key(U'5'));
  const auto seen = [&program] { return program.draw().to_text(); };
  for (int i = 0; i < 20000 && !holds(seen(), "43 %"); ++i) program.tick();
  program.press(Key(U'a'));
  EXPECT_TRUE(holds(seen(), "found before the last change")) << seen();
  held = false;
  wait_until_idle(program);
  EXPECT_FALSE(holds(seen(), "found before the last change")) << seen();
}

// The candidate that one stands on may be in another row of the next list.
TEST(Program, TheCursorStaysOnItsCandidate) {
  FakeOptions options;
  options.reversed_after_adding = true;
  const auto row = [&options](const std::string& script) {
    const std::string text = played(script, {120, 35}, options);
    const std::size_t at = text.find("▸");
    return text.substr(at, text.find('\n', at) - at);
  };
  const std::string second = "5\nwait\nj\nwait";
  EXPECT_TRUE(holds(row(second), "sensor-mass")) << row(second);
  const std::string anew = second + "\na\nwait\n5\nwait";
  EXPECT_TRUE(holds(row(anew), "sensor-mass")) << row(anew);
  const std::string first = "5\nwait\na\nwait\n5\nwait";
  EXPECT_TRUE(holds(row(first), "added-mass")) << row(first);
}

// What is tried first is not what one stands on.
TEST(Program, TheCursorWaitsForItsCandidate) {
  FakeOptions options;
  options.endless_diagnosis = true;
  options.tried_after_adding = 1;
  Program program(testing::fake_workbench(options), {120, 35});
  (void)replay(program, parse_key_script("5\nwait\nj\nA\nwait\n"));
  program.press(Key(U'5'));
  const auto seen = [&program] { return program.draw().to_text(); };
  for (int i = 0; i < 20000 && !holds(seen(), "1 tried"); ++i) program.tick();
  ASSERT_TRUE(holds(seen(), "1 tried")) << seen();
  EXPECT_FALSE(holds(seen(), "▸")) << seen();
  EXPECT_TRUE(holds(seen(), "sensor-mass at acc1 is not tried yet")) << seen();
  program.press(Key(U'a'));
  EXPECT_TRUE(holds(seen(), "5 Diagnose")) << seen();
  EXPECT_FALSE(holds(seen(), "adding")) << seen();
  program.press(Key(U'j'));
  EXPECT_TRUE(holds(seen(), "▸")) << seen();
  program.leave();
}

// Who looks at something else meanwhile goes on looking at it.
TEST(Program, TheEndOfAFitShowsItWhereNoScreenWasChosenSince) {
  for (const char* key : {"", "5", "3"}) {
    std::atomic<bool> held = true;
    FakeOptions options;
    options.held = &held;
    Program program(testing::fake_workbench(options), {});
    (void)replay(program, parse_key_script("5\nwait\n"));
    program.press(Key(U'A'));
    const bool chosen = *key != '\0';
    if (chosen) program.press(Key(static_cast<char32_t>(*key)));
    held = false;
    wait_until_idle(program);
    const std::string text = program.draw().to_text();
    EXPECT_EQ(holds(text, "1 effect added"), !chosen) << key << text;
    EXPECT_TRUE(holds(text, "added added-mass")) << text;
  }
}

// Two effects that came in one step: a model with one of them never was.
TEST(Program, ReportsNoDiagnosisOfAModelThatNeverWas) {
  FakeOptions options;
  options.diagnosed_before = true;
  options.diagnosed_on_the_way = true;
  options.left_with = {{{"added-mass", {}}, true}, {{"joint", {}}, true, true}};
  const std::string text = played("7\nwait\n", {120, 50, false}, options);
  EXPECT_TRUE(holds(text, "missing from the base model")) << text;
  EXPECT_TRUE(holds(text, "the model with 2 effects")) << text;
  EXPECT_FALSE(holds(text, "the model with 1 effect")) << text;
}

TEST(Program, SaysWhereSizesOfOneEffectAddUp) {
  const std::string once = "5\nwait\nja\nwait\n";
  EXPECT_FALSE(holds(played(once, {200, 50}), "counts twice"));
  const std::string twice = played(once + "5\nwait\na\nwait", {200, 50});
  EXPECT_TRUE(holds(twice, "sensor-mass now counts twice at acc1")) << twice;
}

// Yellow is for what one should beware of.
TEST(Program, WarnsInYellowAlone) {
  Program program(testing::fake_workbench(), {120, 35, false});
  (void)replay(program, parse_key_script("5\nwait\n"));
  const auto colour_of = [&program](const std::string& words) {
    const Screen s = program.draw();
    std::istringstream lines(s.to_text());
    std::string line;
    for (int y = 0; std::getline(lines, line); ++y) {
      const std::size_t at = line.find(words);
      if (at == std::string::npos) continue;
      return s.at(text_width(line.substr(0, at)), y).style.colour;
    }
    ADD_FAILURE() << words << " in\n" << s.to_text();
    return Colour::Red;
  };
  EXPECT_NE(colour_of("uniquely identified"), Colour::Yellow);
  program.press(Key(U'j'));
  wait_until_idle(program);
  EXPECT_EQ(colour_of("indistinguishable"), Colour::Yellow);
}

TEST(Program, ShowsTheNewListOnceItIsThere) {
  const std::string text = played("5\nwait\na\nwait\n5\nwait");
  EXPECT_FALSE(holds(text, "outdated")) << text;
}

TEST(Program, AddsWhatIsTaggedInOneStep) {
  const std::string tagged = played("5\nwait\nj\nt\nk\nt");
  EXPECT_TRUE(holds(tagged, "2 tagged")) << tagged;
  EXPECT_TRUE(holds(tagged, "*1")) << tagged;  // the rung's number
  const std::string add = "5\nwait\nj\nt\nk\nt\na\nwait\n";
  const std::string both = played(add);
  // In the order of the list, not of the tags.
  EXPECT_TRUE(holds(both, "added added-mass+")) << both;
  EXPECT_TRUE(holds(both, "2 effects added")) << both;
  const std::string undone = played(add + "u\nwait");
  EXPECT_TRUE(holds(undone, "nothing added yet")) << undone;
  EXPECT_FALSE(holds(played(add + "5\nwait"), "tagged")) << both;
}

TEST(Program, AddsTheWholeVerdictAtOnce) {
  const std::string text = played("5\nwait\njA\nwait");
  EXPECT_TRUE(holds(text, "added added-mass: error")) << text;
  EXPECT_TRUE(holds(text, "1 effect added")) << text;
}

TEST(Program, TagsGoByEscape) {
  const std::string tag = "5\nwait\nt\n";
  EXPECT_TRUE(holds(played(tag), "1 tagged"));
  // The next one is selected, as on the Recording screen.
  EXPECT_TRUE(holds(played(tag), "▸     1.7 %")) << played(tag);
  for (const char* key : {"<Esc>", "k\nt"}) {
    EXPECT_FALSE(holds(played(tag + key), "1 tagged")) << key;
  }
  // A view on top goes first.
  EXPECT_TRUE(holds(played(tag + "m\nwait\n<Esc>"), "1 tagged"));
}

TEST(Program, ShowsNoCandidateThatTheFilterLeavesOut) {
  const std::string text = played("5\nwait\n/zz<Enter>\na");
  EXPECT_TRUE(holds(text, "the filter matches nothing")) << text;
  EXPECT_FALSE(holds(text, "kg")) << text;
  EXPECT_FALSE(holds(text, "added added-mass")) << text;
}

TEST(Program, SaysWhereTaggedOnesLookAlike) {
  const std::string text = played("5\nwait\nt\nt");
  EXPECT_TRUE(holds(text, "neither size will be sure")) << text;
  EXPECT_FALSE(holds(text, "any key closes")) << text;  // the list stays free
}

}  // namespace
}  // namespace tapfit::tui
