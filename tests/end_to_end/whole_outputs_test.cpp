// What the program writes is there as a whole or not at all: on a full disk,
// where it is stopped, and where standard output is full.
#include "tests/end_to_end/written_files.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <string>

namespace tapfit::end_to_end {
namespace {

namespace fs = std::filesystem;

// The shell's limit stands for a disk that is full.
TEST_F(OutputsOfATest, LeaveTheOlderFileOnAFullDisk) {
  const fs::path file = bundle_ / "out.uff";
  write_file(file, "older");
  const int status = shell_status(
      fmt::format("ulimit -f 4; "
                  "%tapfit frf '{}' --uff '{}' --force >/dev/null 2>/dev/null",
                  bundle_.string(),
                  file.string()));
  EXPECT_EQ(status, 1);
  EXPECT_EQ(read_file(file), "older");
  EXPECT_TRUE(parts_in(bundle_).empty());
}

// ThreadSanitizer writes a file of its own there before main(), which the limit
// would stop; the program writes beside its outputs.
constexpr const char* no_temporary_files = "TMPDIR=/nowhere";

// All that write a file, at sizes of the disk that stop them at different
// places: the older file is there as it was, or the whole new one where it has
// room, and nothing beside it.
TEST_F(OutputsOfATest, OfEveryCommandAreWholeOrNotThere) {
  for (const char* command : {"frf %b --uff %o",
                              "modes %b --uff %o",
                              "modes %b --fit %o",
                              "export %b --uff %o",
                              "export %b --deck %o",
                              "report %b -o %o"}) {
    const std::string name = holds(command, "report") ? "out.html" : "out.uff";
    const fs::path file = bundle_ / name;
    std::string line = command;
    line.replace(line.find("%b"), 2, in_bundle(""));
    line.replace(line.find("%o"), 2, in_bundle(name) + " --force");
    EXPECT_EQ(shell_status("%tapfit " + line + " >/dev/null 2>/dev/null"), 0)
        << line;
    const std::size_t whole = read_file(file).size();
    for (const int blocks : {0, 4}) {
      write_file(file, "older");
      const int status =
          shell_status(fmt::format("ulimit -f {}; {} %tapfit {} "
                                   ">/dev/null 2>/dev/null",
                                   blocks,
                                   no_temporary_files,
                                   line));
      const bool may_fit = whole <= 1024 * static_cast<std::size_t>(blocks);
      if (!may_fit) {
        EXPECT_EQ(status, 1) << line;
      }
      if (status == 0) {
        EXPECT_EQ(read_file(file).size(), whole) << line;
      } else {
        EXPECT_EQ(read_file(file), "older") << line;
      }
      EXPECT_TRUE(parts_in(bundle_).empty()) << line;
    }
  }
}

// The text is longer than each of its pictures, or one of them is longer: at
// some limit only a part has room.
TEST_F(OutputsOfATest, OfReportComeWithTheirPicturesOrNotAtAll) {
  for (const int blocks : {1, 16, 48}) {
    const int status =
        shell_status(fmt::format("ulimit -f {}; %tapfit report '{}' -o {} "
                                 ">/dev/null 2>/dev/null",
                                 blocks,
                                 bundle_.string(),
                                 in_bundle("r.md")));
    EXPECT_TRUE(status == 0 || status == 1) << blocks;
    EXPECT_EQ(fs::exists(bundle_ / "r.md"), status == 0) << blocks;
    EXPECT_EQ(fs::exists(bundle_ / "r-files"), status == 0) << blocks;
    EXPECT_TRUE(parts_in(bundle_).empty()) << blocks;
    fs::remove(bundle_ / "r.md");
    fs::remove_all(bundle_ / "r-files");
  }
}

// Whenever the signal comes, the bundle is there as a whole or not at all.
TEST(Outputs, OfSimulateLeaveNothingWhereItIsStopped) {
  const fs::path folder = fresh_folder();
  for (const char* delay : {"0.05", "0.3", "0.8"}) {
    const fs::path bundle = folder / "test";
    fs::remove_all(bundle);
    (void)shell_status(
        fmt::format("timeout -s INT {} %tapfit simulate '{}' "
                    ">/dev/null 2>/dev/null",
                    delay,
                    bundle.string()));
    EXPECT_TRUE(parts_in(folder).empty()) << delay;
    EXPECT_EQ(fs::exists(bundle), fs::exists(bundle / "truth.json")) << delay;
  }
}

// The recordings of a bundle, too: half a file is none.
TEST(Outputs, OfSimulateAreAllThereOrNone) {
  const fs::path bundle = fresh_folder() / "test";
  for (const int kilobytes : {1, 8, 64}) {
    const int status =
        shell_status(fmt::format("ulimit -f {}; %tapfit simulate '{}' "
                                 "--structure ladder --runs 2 --hits 2 "
                                 ">/dev/null 2>/dev/null",
                                 kilobytes,
                                 bundle.string()));
    EXPECT_EQ(status, 1) << kilobytes;
    EXPECT_FALSE(fs::exists(bundle)) << kilobytes;
    EXPECT_TRUE(parts_in(bundle.parent_path()).empty()) << kilobytes;
  }
}

// Whenever a signal comes, of whichever kind.
TEST(Outputs, OfExportAreWholeOrNotThereWhereItIsStopped) {
  const fs::path folder = fresh_folder();
  const fs::path file = folder / "out.uff";
  for (const char* signal : {"INT", "TERM", "HUP", "QUIT"}) {
    for (const char* delay : {"0.02", "0.1", "0.3", "0.6"}) {
      write_file(file, "older");
      (void)shell_status(
          fmt::format("timeout -s {} {} %tapfit export '{}' --records '{}' "
                      "--text --force >/dev/null 2>/dev/null",
                      signal,
                      delay,
                      recorded().string(),
                      file.string()));
      EXPECT_TRUE(parts_in(folder).empty()) << signal << delay;
      const std::string now = read_file(file);
      EXPECT_TRUE(now == "older" || now.ends_with("    -1\n"))
          << signal << delay;
    }
  }
}

TEST(StandardError, ThatIsFullEndsNoCommand) {
  for (const char* command : {"hits", "replay", "run", "modes"}) {
    EXPECT_EQ(shell_status(fmt::format("%tapfit {} '{}' >/dev/null 2>/dev/full",
                                       command,
                                       recorded().string())),
              0)
        << command;
  }
  // A fault has its status though nobody reads the message.
  EXPECT_EQ(shell_status("%tapfit hits /nonexistent >/dev/null 2>/dev/full"),
            1);
  EXPECT_EQ(shell_status("%tapfit no-such --option 2>/dev/full"), 2);
}

TEST(StandardOutput, ThatIsFullIsTold) {
  const fs::path folder = fresh_folder();
  const fs::path said = folder / "said";
  for (const std::string& command :
       {fmt::format("hits '{}'", recorded().string()),
        fmt::format("modes '{}' --json", recorded().string()),
        fmt::format("simulate '{}' --structure ladder --runs 2 --hits 1",
                    (folder / "made").string()),
        std::string("--help"),
        std::string("--version"),
        std::string("score --help"),
        std::string("simulate --help")}) {
    EXPECT_EQ(shell_status(fmt::format(
                  "%tapfit {} >/dev/full 2>'{}'", command, said.string())),
              1)
        << command;
    EXPECT_TRUE(holds(read_file(said), "standard output")) << command;
  }
}

}  // namespace
}  // namespace tapfit::end_to_end
