#include "tui/app/program.hpp"

#include "tests/tui/support/play.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>

namespace tapfit::tui {
namespace {

TEST(Program, WalksAllSevenScreens) {
  const std::vector<std::string> shown{"run-01.wav",
                                       "coherence",
                                       "stabilisation",
                                       "error 38.8 %",
                                       "verdict: added-mass",
                                       "ladder",
                                       "Error ladder"};
  for (const Canvas& canvas : {Canvas{80, 24, false}, Canvas{120, 35, false}}) {
    for (int screen = 1; screen <= 7; ++screen) {
      const std::string text =
          played(fmt::format("{}\nwait\n<Tab>\nwait", screen), canvas);
      const auto index = static_cast<std::size_t>(screen - 1);
      EXPECT_TRUE(holds(text, shown[index])) << text;
      EXPECT_TRUE(holds(text, "q quit")) << text;
      EXPECT_EQ(std::count(text.begin(), text.end(), '\n'), canvas.height);
      expect_fits(text, canvas.width);
    }
  }
}

TEST(Program, BeginsWithTheFrfsWhereTheyCameReady) {
  FakeOptions options;
  options.ready_frfs = true;
  const std::string text = played("wait", {}, options);
  EXPECT_TRUE(holds(text, "coh")) << text;
  EXPECT_FALSE(holds(text, "run-01.wav")) << text;
}

TEST(Program, SaysThatATestWithoutRecordingsHasNone) {
  FakeOptions options;
  options.ready_frfs = true;
  const std::string text = played("1\nwait", {}, options);
  EXPECT_TRUE(holds(text, "it has no recordings")) << text;
  EXPECT_FALSE(holds(text, "run again")) << text;
  EXPECT_FALSE(holds(text, "Space accept")) << text;
}

TEST(Program, SortsFrfsAndCandidates) {
  for (const int width : {80, 150}) {
    const Canvas canvas{width, 40, false};
    const std::string frfs = played("4\nwait\ns\ns\n", canvas);
    EXPECT_TRUE(holds(frfs, "sorted by error")) << frfs;
    EXPECT_TRUE(
        holds(played("4\nwait\n<Tab><Tab>s", canvas), "sorted by measured Hz"));
    const std::string rung = played("5\nwait\ns", canvas);
    EXPECT_TRUE(holds(rung, "sorted by rung")) << rung;
    const std::string error = played("5\nwait\nsssssss", canvas);
    EXPECT_TRUE(holds(error, "sorted by error")) << error;
  }
}

TEST(Program, HoldsOnlyAsciiInAsciiMode) {
  for (const char screen : std::string("1234567")) {
    const std::string script =
        fmt::format("{}\nwait\nscreen\n?\nscreen", screen);
    const std::string text = played(script, {100, 30, true});
    for (const char c : text) {
      ASSERT_LT(static_cast<unsigned char>(c), 0x80U) << text;
    }
  }
}

TEST(Program, AddsTheCandidateAndTakesItOffAgain) {
  const std::string added = played("5\nwait\na\nwait");
  EXPECT_TRUE(holds(added, "added added-mass: error 38.8 % → 0.01 %")) << added;
  EXPECT_TRUE(holds(added, "1 effect added: error")) << added;
  const std::string undone = played("5\nwait\na\nwait\nu\nwait");
  EXPECT_TRUE(holds(undone, "nothing added yet")) << undone;
  const std::string redone = played("5\nwait\na\nwait\nu\nwait\n<C-r>\nwait");
  EXPECT_TRUE(holds(redone, "1 effect added: error")) << redone;
}

TEST(Program, DropsAndPutsInModesAsTyped) {
  const std::string dropped = played("3\nwait\n:drop 12\n<Enter>\nwait");
  EXPECT_TRUE(holds(dropped, "dropped the mode at 12 Hz: 2 modes")) << dropped;
  // On this screen u and Ctrl-R are about the modes.
  const std::string undone =
      played("3\nwait\n:drop 12\n<Enter>\nwait\nu\nwait");
  EXPECT_TRUE(holds(undone, "undone: 3 modes")) << undone;
  const std::string redone =
      played("3\nwait\n:drop 12\n<Enter>\nwait\nu\nwait\n<C-r>\nwait");
  EXPECT_TRUE(holds(redone, "redone: 2 modes")) << redone;
  const std::string picked = played("3\nwait\n:pick 33\n<Enter>\nwait");
  EXPECT_TRUE(holds(picked, "put a mode in at 33 Hz: 4 modes")) << picked;
  const std::string band = played("3\nwait\n:band 5 20\n<Enter>\nwait");
  EXPECT_TRUE(holds(band, "band 5 to 20 Hz: 3 modes")) << band;
  const std::string pair = played("3\nwait\n:pair 2:none\n<Enter>\nwait");
  EXPECT_TRUE(holds(pair, "mode 2 is paired by hand")) << pair;
  const std::string none = played("4\nwait\n:pair 1:99\n<Enter>\nwait");
  EXPECT_TRUE(holds(none, "the model has no mode 99")) << none;
  const std::string wrong = played("3\nwait\n:pair 9:1\n<Enter>\nwait");
  EXPECT_TRUE(holds(wrong, "there is no measured mode 9")) << wrong;
  const std::string bad = played("3\nwait\n:drop x\n<Enter>\nwait");
  EXPECT_TRUE(holds(bad, ":drop 12.98")) << bad;
  const std::string below = played("3\nwait\n:band -5 20\n<Enter>\nwait");
  EXPECT_TRUE(holds(below, ":band 10 60")) << below;
}

TEST(Program, DropsAndPutsInModesByOneKey) {
  const std::string dropped = played("3\nwait\nj\nx\nwait");
  EXPECT_TRUE(holds(dropped, "dropped the mode at 17.5 Hz: 2 modes"))
      << dropped;
  const std::string undone = played("3\nwait\nj\nx\nwait\nu\nwait");
  EXPECT_TRUE(holds(undone, "undone: 3 modes")) << undone;
  const std::string nowhere = played("3\nwait\np\nwait");
  EXPECT_TRUE(holds(nowhere, "put the cursor on a pole first")) << nowhere;
  const std::string picked = played("3\nwait\nl\np\nwait");
  EXPECT_TRUE(holds(picked, "put a mode in at ")) << picked;
  EXPECT_TRUE(holds(picked, "4 modes")) << picked;
}

TEST(Program, SwitchesAnEffectOffAndOn) {
  const std::string off = played("5\nwait\na\nwait\n<Space>\nwait");
  EXPECT_TRUE(holds(off, "added-mass switched off")) << off;
  EXPECT_TRUE(holds(off,
                    "nothing added yet: error 38.8 %, 1 off, floor 3.1 %; 5 "
                    "finds what is missing"))
      << off;
  const std::string on = played(
      "5\nwait\na\nwait\n<Space>\nwait\n:toggle 1<Enter>\n"
      "wait");
  EXPECT_TRUE(holds(on, "added-mass switched on: error 38.8 % → 0.01 %")) << on;
  EXPECT_TRUE(holds(on, "1 effect added: error")) << on;
  const std::string undone = played("5\nwait\na\nwait\n<Space>\nwait\nu\nwait");
  EXPECT_TRUE(holds(undone, "1 effect added: error")) << undone;
}

// What stands behind it is the error of the model before, not of the rung
// before: both effects leave 0.01 %, the base model 38.8 %.
TEST(Program, TellsTheErrorsBeforeAndAfterAChange) {
  const std::string off =
      played("5\nwait\nt\nt\na\nwait\n<Space>\nwait", {120, 35});
  EXPECT_TRUE(holds(off, "switched off: error 0.01 % → 0.01 %")) << off;
}

TEST(Program, TellsWhenTheSessionCannotBeSaved) {
  testing::FakeOptions options;
  options.unsaved = "no space is left";
  EXPECT_TRUE(holds(played("5\nwait\na\nwait", {100, 30, false}, options),
                    "no space is left"));
}

TEST(Program, TakesUpWhatWasLeftLastTime) {
  testing::FakeOptions options;
  options.left_with = {{{"added-mass", {}}, true}, {{"joint", {}}, false}};
  const std::string first = played("wait", {100, 30, false}, options);
  EXPECT_TRUE(
      holds(first, "as left last time: 1 effect added, 1 effect switched off"))
      << first;
  EXPECT_FALSE(holds(first, "0 hits")) << first;
  const std::string update = played("6\nwait", {100, 30, false}, options);
  EXPECT_TRUE(holds(update, "1 effect added: error")) << update;
  EXPECT_TRUE(holds(update, "1 off")) << update;
}

TEST(Program, ReportsWhatWasFoundBeforeAndAfterAdding) {
  const std::string before = "missing from the base model: added-mass";
  const std::string after = "missing from the model with 1 effect: added-mass";
  const std::string added = played("5\nwait\na\nwait\n7\nwait");
  EXPECT_TRUE(holds(added, before)) << added;
  EXPECT_FALSE(holds(added, after)) << added;
  const std::string again = played("5\nwait\na\nwait\n5\nwait\n7\nwait");
  EXPECT_TRUE(holds(again, before)) << again;
  EXPECT_TRUE(holds(again, after)) << again;
  const std::string undone =
      played("5\nwait\na\nwait\n5\nwait\nu\nwait\n7\nwait");
  EXPECT_TRUE(holds(undone, before)) << undone;
  EXPECT_FALSE(holds(undone, after)) << undone;
}

TEST(Program, MarksWhatWasAddedLast) {
  FakeOptions options;
  options.left_with = {{{"dashpot", {}}, true}, {{"joint", {}}, true}};
  const std::string first = played("6\nwait\np", {}, options);
  EXPECT_TRUE(holds(first, "▸dashpot")) << first;
  const std::string added =
      played("6\nwait\np:add added-mass@5<Enter>\nwait", {}, options);
  EXPECT_TRUE(holds(added, "▸added-mass")) << added;
}

TEST(Program, AddsByName) {
  EXPECT_TRUE(holds(played("6\nwait\n:add added-mass@5<Enter>\nwait"),
                    "1 effect added: error"));
  EXPECT_TRUE(
      holds(played("6\nwait\n:add what@5<Enter>\nwait"), "no such effect"));
}

TEST(Program, ScrollsTheMacs) {
  const std::string report = played("7\nwait", {80, 50, false});
  EXPECT_TRUE(holds(report, "   5.25 18.4 32.8")) << report;
  const std::string beside = played("7\nwait\nl", {80, 50, false});
  EXPECT_FALSE(holds(beside, "5.25 18.4")) << beside;
  EXPECT_TRUE(holds(beside, "18.4 32.8")) << beside;
  EXPECT_EQ(played("7\nwait\nlh", {80, 50, false}), report);
  // Past the last one there is nothing.
  EXPECT_EQ(played("7\nwait\nlllll", {80, 50, false}),
            played("7\nwait\nll", {80, 50, false}));
}

TEST(Program, ClearsWhatWasToldAtTheNextKey) {
  EXPECT_TRUE(holds(played("6\nwait\nu\nwait"), "nothing to undo"));
  EXPECT_FALSE(holds(played("6\nwait\nu\nwait\nj"), "nothing to undo"));
  EXPECT_FALSE(holds(played("6\nwait\nu\nwait\n2"), "nothing to undo"));
}

TEST(Program, ActsOnNothingThatAFilterHides) {
  const std::string text = played("1\nwait\n/zzz<Enter> \nwait");
  EXPECT_TRUE(holds(text, "nothing matches")) << text;
  EXPECT_FALSE(holds(text, "overrul")) << text;
}

TEST(Program, TheKeyThatClosesAMessageDoesNothingElse) {
  const std::string wrong =
      "6\nwait\n:add an-effect-with-a-name-too-long-for-the-line<Enter>\nwait";
  EXPECT_TRUE(holds(played(wrong), "any key closes")) << played(wrong);
  for (const char* key : {"q", ":", "x", "n", "2", "u"}) {
    EXPECT_EQ(played(wrong + "\n" + key + "\nwait"), played(wrong + "\n<Esc>"))
        << key;
  }
}

TEST(Program, ShowsErrorsWithoutLeaving) {
  FakeOptions options;
  options.hits_fail = true;
  const std::string text = played("wait", {}, options);
  EXPECT_TRUE(holds(text, "no hit was found")) << text;
  EXPECT_TRUE(holds(text, "(r: run again)")) << text;
  EXPECT_TRUE(holds(played("wait\n2\nwait", {}, options), "|H|"));
}

TEST(Program, SaysWhyThereIsNothingWithoutAModel) {
  FakeOptions options;
  options.model = false;
  for (const char screen : std::string("4567")) {
    const std::string text =
        played(fmt::format("{}\nwait", screen), {}, options);
    EXPECT_TRUE(holds(text, "has no model")) << text;
    EXPECT_TRUE(holds(text, "test.json")) << text;
  }
  EXPECT_TRUE(holds(played("3\nwait", {}, options), "4Z+"));
}

TEST(Program, ReportsTheModesWithoutAModel) {
  FakeOptions options;
  options.model = false;
  const std::string text = played("7\nwait", {}, options);
  EXPECT_TRUE(holds(text, "damping %")) << text;
  EXPECT_FALSE(holds(text, "base model")) << text;
}

TEST(Program, StopsWorkOnEscape) {
  FakeOptions options;
  options.endless_modes = true;
  Program program(testing::fake_workbench(options), {});
  program.press(Key(U'3'));
  for (int i = 0; i < 20000 && !holds(program.draw().to_text(), "43 %"); ++i) {
    program.tick();
  }
  EXPECT_TRUE(holds(program.draw().to_text(), "fitting … 43 %"));
  // Screens whose results are there stay usable meanwhile.
  program.press(Key(U'2'));
  EXPECT_TRUE(holds(program.draw().to_text(), "|H|"));
  // One whose result has to wait says for what.
  program.press(Key(U'4'));
  const std::string waits = program.draw().to_text();
  EXPECT_TRUE(holds(waits, "comparison: waiting for other work")) << waits;
  EXPECT_TRUE(holds(waits, "modes: fitting … 43 %")) << waits;
  program.press(Key(U'3'));
  program.press(Key(keys::escape));
  wait_until_idle(program);
  EXPECT_TRUE(holds(program.draw().to_text(), "stopped (r: run again)"));
}

TEST(Program, AsksForRoomWhenThereIsTooLittle) {
  const std::string text = played("wait\nresize 60 20");
  EXPECT_TRUE(holds(text, "80 x 24")) << text;
  expect_fits(text, 60);
  EXPECT_NO_THROW(played("wait\nresize 1 1"));
  EXPECT_TRUE(holds(played("resize 60 20\nresize 90 30\nwait"), "run-01.wav"));
}

TEST(Program, FiltersLists) {
  const std::string text = played("2\nwait\n/4Z+ / 4<Enter>");
  EXPECT_TRUE(holds(text, "4Z+ / 4Z+"));
  EXPECT_FALSE(holds(text, "6Z+ / 3Z+")) << text;
  EXPECT_TRUE(holds(played("2\nwait\n/4Z+ / 4<Enter><Esc>"), "6Z+ / 3Z+"));
}

// Maps, shapes and curves stand beside each other where there is room.
TEST(Program, ComparesAllAtOnceOnAWideScreen) {
  const std::vector<std::string> parts{"error [%] by band",
                                       "measured Hz",
                                       "MAC in %",
                                       "error at the measured points",
                                       "━ measured",
                                       "|residual|"};
  const std::string wide = played("4\nwait", {200, 50});
  for (const std::string& part : parts) {
    EXPECT_TRUE(holds(wide, part)) << part << "\n" << wide;
  }
  EXPECT_FALSE(holds(played("4\nwait", {120, 35}), "MAC in %"));
}

TEST(Program, GoesFromNumbersToTheirCurvesAndBack) {
  // The map: a band of the first FRF, its curves, then the FRF by itself.
  const std::string band = played("4\nwait\n<Tab>l<Enter>\nwait");
  EXPECT_TRUE(holds(band, "error [%] by band (upper edge, Hz)")) << band;
  const std::string frf = played("4\nwait\n<Tab>l<Enter><Enter>\nwait");
  EXPECT_TRUE(holds(frf, "FRF (Esc back)") || holds(frf, "peak")) << frf;
  const std::string wide =
      played("4\nwait\n<Tab>l<Enter><Enter>\nwait", {120, 35});
  EXPECT_TRUE(holds(wide, "Compare > FRF (Esc back)")) << wide;
  const std::string back =
      played("4\nwait\n<Tab>l<Enter><Enter>\nwait\n<Esc>\nwait");
  EXPECT_TRUE(holds(back, "error 38.8 %")) << back;
  // From an FRF to the hits behind it.
  const std::string hits = played("2\nwait\njj<Enter>\nwait", {120, 35});
  EXPECT_TRUE(holds(hits, "run 2 of 2")) << hits;
  EXPECT_TRUE(holds(hits, "FRF > Recording (Esc back)")) << hits;
  // From the MAC to the shapes.
  const std::string shapes =
      played("4\nwait\n<Tab><Tab><Tab><Enter>\nwait", {120, 35});
  EXPECT_TRUE(holds(shapes, "Compare > Modes (Esc back)")) << shapes;
  EXPECT_TRUE(holds(shapes, "over model")) << shapes;
}

TEST(Program, ShowsHowTheFitCameAbout) {
  const std::string added = "5\nwait\na\nwait\n";
  const Canvas canvas{120, 35, false};
  EXPECT_TRUE(holds(played(added + "<Tab><Tab>\nwait", canvas),
                    "fit with added-mass: 3 steps, converged; on the damped "
                    "line"));
  const std::string correlation =
      played(added + "<Tab><Tab><Tab>\nwait", canvas);
  EXPECT_TRUE(holds(correlation, "  42")) << correlation;
  EXPECT_TRUE(holds(correlation, "All parameters are identifiable."));
  EXPECT_TRUE(holds(played(added + "<Tab><Tab><Tab><Tab>\nwait", canvas),
                    "no lambda to choose"));
}

TEST(Program, MapsTheSignatureOfEveryGrid) {
  const std::string text = played("5\nwait\nm\nwait", {120, 35});
  EXPECT_TRUE(holds(text, "alone explain: 5 97.0 %, 6 90.0 %, 3 60.0 %"))
      << text;
}

TEST(Program, Quits) {
  Program program(testing::fake_workbench(), {});
  program.press(Key(U'q'));
  EXPECT_TRUE(program.quit());
}

TEST(Program, TakesEveryKeyOnEveryScreen) {
  Program program(testing::fake_workbench(), {});
  for (char32_t screen = U'1'; screen <= U'7'; ++screen) {
    program.press(Key(screen));
    wait_until_idle(program);
    for (char32_t code = U' '; code < 0x7F; ++code) {
      if (code == U'q' || (code >= U'1' && code <= U'7')) continue;
      program.press(Key(code));
      program.tick();
      program.animate();
      (void)program.draw();
      program.press(Key(keys::escape));
    }
    for (char32_t code = keys::enter; code <= keys::resize; ++code) {
      program.press(Key(code));
      (void)program.draw();
    }
    wait_until_idle(program);
    expect_fits(program.draw().to_text(), 80);
  }
}

}  // namespace
}  // namespace tapfit::tui
