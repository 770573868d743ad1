// What the program writes: never over what it reads, over other files only with
// --force or a y.
#include "tests/end_to_end/written_files.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <array>
#include <cstdlib>
#include <map>

namespace tapfit::end_to_end {
namespace {

namespace fs = std::filesystem;

TEST_F(OutputsOfATest, NeverGoOverWhatItReads) {
  fs::create_symlink("measured.uff", bundle_ / "link.uff");
  const std::string measured = read_file(bundle_ / "measured.uff");
  const std::string test = read_file(bundle_ / "test.json");
  const std::string deck = read_file(bundle_ / "model.bdf");
  struct Attempt {
    const char* command;
    const char* option;
    const char* file;
  };
  for (const Attempt& attempt :
       {Attempt{"frf", "--uff", "measured.uff"},
        Attempt{"frf", "--uff", "./measured.uff"},
        Attempt{"frf", "--uff", "link.uff"},
        Attempt{"modes", "--uff", "measured.uff"},
        Attempt{"modes", "--fit", "measured.uff"},
        Attempt{"export", "--uff", "measured.uff"},
        Attempt{"export", "--deck", "model.bdf"},
        Attempt{"export", "--records", "test.json"},
        Attempt{"predict --effect added-mass@3=1", "--uff", "measured.uff"},
        Attempt{"report", "-o", "measured.uff"},
        Attempt{"report", "-o", "test.json"},
        Attempt{"report", "-o", "session.json"}}) {
    for (const char* force : {"", "--force"}) {
      const ProgramResult result =
          run(attempt.command,
              fmt::format(
                  "{} {} {}", attempt.option, in_bundle(attempt.file), force));
      EXPECT_EQ(result.exit_status, 1) << attempt.command << attempt.file;
      EXPECT_EQ(result.out, "") << attempt.command << attempt.file;
      EXPECT_TRUE(holds(result.err, "never written over")) << result.err;
      EXPECT_TRUE(holds(result.err, "-2.")) << result.err;
    }
  }
  EXPECT_EQ(read_file(bundle_ / "measured.uff"), measured);
  EXPECT_EQ(read_file(bundle_ / "test.json"), test);
  EXPECT_EQ(read_file(bundle_ / "model.bdf"), deck);
}

TEST_F(OutputsOfATest, AreAllPlotsAndTablesInTheirFolders) {
  const std::string folders = fmt::format(
      "--plots {} --tables {}", in_bundle("plots"), in_bundle("tables"));
  const ProgramResult result = run("export", folders);
  ASSERT_EQ(result.exit_status, 0) << result.err;
  for (const char* table : {"frf", "modes", "compare", "diagnose"}) {
    const fs::path file = bundle_ / "tables" / fmt::format("{}.csv", table);
    EXPECT_TRUE(fs::exists(file)) << file;
    EXPECT_TRUE(holds(result.out, fmt::format("tables/{}.csv", table)));
  }
  for (const char* plot : {"frf", "compare"}) {
    EXPECT_TRUE(holds(result.out, fmt::format("plots/{}", plot))) << result.out;
  }
  EXPECT_EQ(run("export", folders).exit_status, 1) << "they are there";
  EXPECT_EQ(run("export", folders + " --force").exit_status, 0);
}

TEST_F(OutputsOfATest, GoOverAnotherFileOnlyWhereThatIsAskedFor) {
  const fs::path file = bundle_ / "out.uff";
  write_file(file, "older");
  const std::string option = "--uff " + in_bundle("out.uff");
  const ProgramResult refused = run("frf", option);
  EXPECT_EQ(refused.exit_status, 1);
  EXPECT_TRUE(holds(refused.err, "out-2.uff")) << refused.err;
  EXPECT_TRUE(holds(refused.err, "--force")) << refused.err;
  EXPECT_EQ(read_file(file), "older");
  EXPECT_EQ(run("frf", option + " --force").exit_status, 0);
  EXPECT_TRUE(holds(read_file(file), "    58"));
  EXPECT_TRUE(parts_in(bundle_).empty());
}

// Somebody names a recording so while the hits are still replayed.
TEST_F(OutputsOfATest, NeverGoOverWhatCameMeanwhile) {
  const fs::path test = fresh_folder() / "played";
  fs::copy(recorded(), test);
  const std::string recording = read_file(test / "run-01.flac");
  for (const char* comes : {"ln -s run-01.flac late.uff",
                            "ln run-01.flac late.uff",
                            "echo other > late.uff"}) {
    fs::remove(test / "late.uff");
    const int status = shell_status(fmt::format(
        "cd '{}'; {{ %tapfit replay . --speed 100 --uff late.uff "
        ">/dev/null 2>err.txt; echo $? >status; }} & "
        "until grep -q ' N ' '{}'/err.txt 2>/dev/null; do sleep 0.02; done; "
        "{}; wait; exit $(cat status)",
        test.string(),
        test.string(),
        comes));
    EXPECT_EQ(status, 1) << comes;
    EXPECT_TRUE(holds(read_file(test / "err.txt"), "late.uff")) << comes;
    EXPECT_EQ(read_file(test / "run-01.flac"), recording) << comes;
  }
  EXPECT_EQ(read_file(test / "late.uff"), "other\n");
  EXPECT_TRUE(parts_in(test).empty());
}

TEST_F(OutputsOfATest, OfKeysGoBesideInputsAndAskOtherwise) {
  const std::string measured = read_file(bundle_ / "measured.uff");
  const std::string seen = keys("7\nwait\nf\nwait\n");
  EXPECT_TRUE(holds(seen, "measured-2.uff")) << seen;
  EXPECT_EQ(read_file(bundle_ / "measured.uff"), measured);
  EXPECT_TRUE(holds(read_file(bundle_ / "measured-2.uff"), "    58"));

  write_file(bundle_ / "report.html", "older");
  EXPECT_TRUE(
      holds(keys("7\nwait\nw\n"), "report.html is there: y replaces it"));
  EXPECT_TRUE(holds(keys("7\nwait\nw\n<Esc>\n"), "nothing written"));
  EXPECT_TRUE(holds(keys("7\nwait\nw\nn\nwait\n"), "report-2.html"));
  EXPECT_EQ(read_file(bundle_ / "report.html"), "older");
  EXPECT_TRUE(holds(keys("7\nwait\nw\ny\nwait\n"), "written: "));
  EXPECT_TRUE(holds(read_file(bundle_ / "report.html"), "</html>"));
  fs::remove(bundle_ / "report.html");
  fs::create_symlink("elsewhere.html", bundle_ / "report.html");
  EXPECT_TRUE(
      holds(keys("7\nwait\nw\n"), "report.html is there: y replaces it"));
}

TEST_F(OutputsOfATest, OfSimulateNeverReplaceAMeasuredTest) {
  const std::string test = read_file(bundle_ / "test.json");
  const ProgramResult result =
      run("simulate", "--structure ladder --runs 2 --hits 1 --force");
  EXPECT_EQ(result.exit_status, 1);
  EXPECT_TRUE(holds(result.err, "is an input of the test")) << result.err;
  EXPECT_TRUE(holds(result.err, "another folder")) << result.err;
  EXPECT_EQ(read_file(bundle_ / "test.json"), test);
  EXPECT_FALSE(fs::exists(bundle_ / "truth.json"));
}

/// What is in a folder by name, folders left out.
std::map<std::string, std::string> contents_of(const fs::path& folder) {
  std::map<std::string, std::string> contents;
  for (const auto& entry : fs::directory_iterator(folder)) {
    if (!entry.is_regular_file()) continue;
    contents[entry.path().filename().string()] = read_file(entry.path());
  }
  return contents;
}

ProgramResult simulated(const fs::path& folder, const std::string& options) {
  return run_tapfit(
      fmt::format("simulate '{}' --structure plate --runs 2 --hits 2 "
                  "--effect none {}",
                  folder.string(),
                  options));
}

TEST(Outputs, OfSimulateTakeNoFileAway) {
  const fs::path folder = fresh_folder() / "test";
  fs::create_directory(folder);
  write_file(folder / "run-03.flac", "mine");
  EXPECT_EQ(simulated(folder, "").exit_status, 0);
  EXPECT_EQ(read_file(folder / "run-03.flac"), "mine");
  EXPECT_EQ(simulated(folder, "").exit_status, 1);
  EXPECT_EQ(simulated(folder, "--seed 2 --force").exit_status, 0);
  EXPECT_EQ(read_file(folder / "run-03.flac"), "mine");
}

// Whatever its file is called, and whatever lies beside it.
TEST(Outputs, OfSimulateAndImportLeaveEveryTestAsItIs) {
  const fs::path folder = fresh_folder() / "frame";
  fs::copy(recordings() / "solar-panel-frame", folder);
  const auto both = [&folder] {
    const auto before = contents_of(folder);
    const ProgramResult made = simulated(folder, "--force");
    EXPECT_EQ(made.exit_status, 1) << made.out;
    EXPECT_TRUE(holds(made.err, "is an input of the test")) << made.err;
    EXPECT_TRUE(contents_of(folder) == before);
  };
  both();  // with a truth.json that lists no files
  fs::rename(folder / "test.json", folder / "campaign.json");
  fs::remove(folder / "truth.json");
  both();

  const fs::path table = folder.parent_path() / "run-01.csv";
  write_file(table, "t,f,a\n0,1,3\n.01,2,-400\n");
  std::string test = read_file(folder / "campaign.json");
  test.replace(test.find("run-01.flac"), 11, "run-01.wav");
  write_file(folder / "campaign.json", test);
  write_file(folder / "run-01.wav", "measured");
  const ProgramResult imported = run_tapfit(
      fmt::format("import '{}' -o '{}' --hammer f@1Z+ --sensor a@2Z+ --time t "
                  "--force",
                  table.string(),
                  folder.string()));
  EXPECT_EQ(imported.exit_status, 1);
  EXPECT_EQ(read_file(folder / "run-01.wav"), "measured");
  EXPECT_FALSE(fs::exists(folder / "test.json"));
}

TEST(Outputs, OfImportLeaveTheIncludesOfItsDeck) {
  const fs::path folder = fresh_folder();
  const fs::path table = folder / "run-01.csv";
  write_file(table, "t,f,a\n0,1,3\n.01,2,-400\n");
  write_file(folder / "model.bdf", "INCLUDE 'test/run-01.wav'\n");
  fs::create_directory(folder / "test");
  write_file(folder / "test" / "run-01.wav", "GRID,1,,0.,0.,0.\n");
  const ProgramResult imported = run_tapfit(
      fmt::format("import '{}' -o '{}' --hammer f@1Z+ --sensor a@2Z+ --time t "
                  "--deck '{}' --force",
                  table.string(),
                  (folder / "test").string(),
                  (folder / "model.bdf").string()));
  EXPECT_EQ(imported.exit_status, 1);
  EXPECT_TRUE(holds(read_file(folder / "test" / "run-01.wav"), "GRID"));
}

TEST_F(OutputsOfATest, OfReportReplacePicturesOnlyWhereThatIsAskedFor) {
  fs::create_directory(bundle_ / "r-files");
  write_file(bundle_ / "r-files" / "frf.svg", "mine");
  const std::string option = "-o " + in_bundle("r.md");
  const ProgramResult refused = run("report", option);
  EXPECT_EQ(refused.exit_status, 1);
  EXPECT_TRUE(holds(refused.err, "r-files/frf.svg")) << refused.err;
  EXPECT_TRUE(holds(refused.err, "r-2.md")) << refused.err;
  EXPECT_EQ(read_file(bundle_ / "r-files" / "frf.svg"), "mine");
  EXPECT_EQ(run("report", option + " --force").exit_status, 0);
  EXPECT_TRUE(holds(read_file(bundle_ / "r-files" / "frf.svg"), "</svg>"));
}

TEST_F(OutputsOfATest, OfReportAreRefusedUnderAnotherFormatsName) {
  for (const char* name : {"r.pdf", "r.txt"}) {
    const ProgramResult refused = run("report", "-o " + in_bundle(name));
    EXPECT_EQ(refused.exit_status, 1);
    EXPECT_TRUE(holds(refused.err, "HTML or Markdown")) << refused.err;
    EXPECT_FALSE(fs::exists(bundle_ / name));
  }
}

TEST(Outputs, OfEveryCommandThatWritesCanBeForced) {
  const std::string page = read_file(TAPFIT_SOURCE_DIR "/docs/commands.md");
  EXPECT_TRUE(holds(page, "`--force`"));
  for (const char* command : {"frf",
                              "replay",
                              "modes",
                              "session",
                              "report",
                              "export",
                              "import",
                              "paper",
                              "simulate"}) {
    const ProgramResult help = run_tapfit(fmt::format("{} --help", command));
    EXPECT_TRUE(holds(help.out, "--force")) << command << help.out;
  }
}

// Replay needs no deck, and its INCLUDEs are inputs all the same.
TEST(Outputs, OfReplayLeaveTheIncludesOfADeckThatCannotBeRead) {
  const fs::path bundle = fresh_folder() / "test";
  fs::copy(recorded(), bundle);
  fs::rename(bundle / "model.bdf", bundle / "head.inc");
  write_file(bundle / "model.bdf",
             "INCLUDE 'missing.inc'\nINCLUDE 'head.inc'\nENDDATA\n");
  const std::string head = read_file(bundle / "head.inc");
  const ProgramResult result =
      run_tapfit(fmt::format("replay '{}' --uff '{}' --force",
                             bundle.string(),
                             (bundle / "head.inc").string()));
  EXPECT_EQ(result.exit_status, 1);
  EXPECT_TRUE(holds(result.err, "is an input of the test")) << result.err;
  EXPECT_EQ(read_file(bundle / "head.inc"), head);
}

// What six commands keep at once is there, or they have said that it is not.
TEST_F(OutputsOfATest, OfChoicesKeptAtOnceAreKeptOrTold) {
  const fs::path folder = bundle_.parent_path();
  const fs::path bundle = folder / "frame";
  fs::copy(recordings() / "solar-panel-frame", bundle);
  constexpr std::array<double, 6> modes_hz = {
      2.0771, 7.2323, 12.9321, 23.1671, 36.6989, 48.3436};
  const auto file = [&folder](const char* name, int k) {
    return (folder / fmt::format("{}{}", name, k)).string();
  };
  std::string line;
  for (int k = 1; k <= 6; ++k) {
    line += fmt::format(
        "( '{}' modes '{}' --drop {} --session --keep >/dev/null 2>'{}'; "
        "echo $? >'{}' ) & ",
        TAPFIT_PROGRAM,
        bundle.string(),
        modes_hz.at(static_cast<std::size_t>(k - 1)),
        file("err", k),
        file("status", k));
  }
  (void)std::system((line + "wait").c_str());
  const std::string kept = read_file(bundle / "session.json");
  int done = 0;
  for (int k = 1; k <= 6; ++k) {
    const bool well = read_file(file("status", k)) == "0\n";
    done += well ? 1 : 0;
    const double own = modes_hz.at(static_cast<std::size_t>(k - 1));
    EXPECT_EQ(holds(kept, fmt::format("{}", own)), well)
        << kept << read_file(file("err", k));
    EXPECT_EQ(holds(read_file(file("err", k)), "meanwhile"), !well);
  }
  EXPECT_GT(done, 0);
}

}  // namespace
}  // namespace tapfit::end_to_end
