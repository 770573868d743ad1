// What is written is there as a whole, or as it was before.
#include "acquisition/foundation/output_file.hpp"

#include "acquisition/foundation/input_error.hpp"
#include "tests/acquisition/support/temporary_folder.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <iterator>
#include <sys/stat.h>
#include <unistd.h>

namespace tapfit::acquisition {
namespace {

namespace fs = std::filesystem;

std::string content_of(const fs::path& file) {
  std::ifstream in(file, std::ios::binary);
  return {std::istreambuf_iterator<char>(in), {}};
}

std::ptrdiff_t entries_of(const fs::path& folder) {
  return std::distance(fs::directory_iterator(folder),
                       fs::directory_iterator());
}

class Outputs : public ::testing::Test {
 protected:
  testing::TemporaryFolder folder_;
};

TEST_F(Outputs, FileTakesItsPlaceWhenItIsDone) {
  const fs::path file = folder_.write("a.txt", "older");
  fs::permissions(file, fs::perms::owner_read | fs::perms::owner_write);
  OutputFile output(file, {{}, true});
  output.stream() << "newer";
  output.stream().flush();
  EXPECT_EQ(content_of(file), "older");
  output.commit();
  EXPECT_EQ(content_of(file), "newer");
  EXPECT_EQ(fs::status(file).permissions(),
            fs::perms::owner_read | fs::perms::owner_write);
  EXPECT_EQ(entries_of(folder_.path()), 1);
}

TEST_F(Outputs, FileThatIsGivenUpLeavesTheOlderOne) {
  const fs::path file = folder_.write("a.txt", "older");
  { OutputFile(file, {{}, true}).stream() << "half"; }
  EXPECT_EQ(content_of(file), "older");
  EXPECT_EQ(entries_of(folder_.path()), 1);
  { OutputFile(folder_.path() / "none.txt", {}).stream() << "half"; }
  EXPECT_EQ(entries_of(folder_.path()), 1);
}

// Whoever knows what unfinished files are called could have put a link there.
TEST_F(Outputs, WhatHasTheNameOfAnUnfinishedFileStays) {
  const fs::path mine = folder_.write("mine.txt", "mine");
  const auto unfinished = [this](int number) {
    return folder_.path() / fmt::format("a.txt.{}-{}.part", ::getpid(), number);
  };
  // The count goes on over all files of the program.
  for (int number = 1; number < 100; ++number) {
    fs::create_symlink("mine.txt", unfinished(number));
  }
  write_file(folder_.path() / "a.txt", "other", {});
  EXPECT_EQ(content_of(mine), "mine");
  EXPECT_FALSE(fs::is_symlink(folder_.path() / "a.txt"));
  EXPECT_EQ(content_of(folder_.path() / "a.txt"), "other");
}

TEST_F(Outputs, FileWithoutAPlaceIsRefused) {
  EXPECT_THROW(write_file(folder_.path() / "no" / "a.txt", "x", {}),
               InputError);
  EXPECT_THROW(write_file(folder_.path(), "x", {}), InputError);
  EXPECT_EQ(entries_of(folder_.path()), 0);
}

TEST_F(Outputs, LinkStaysAndItsFileIsReplaced) {
  const fs::path file = folder_.write("a.txt", "older");
  const fs::path link = folder_.path() / "link";
  fs::create_symlink("a.txt", link);
  write_file(link, "newer", {{}, true});
  EXPECT_TRUE(fs::is_symlink(link));
  EXPECT_EQ(content_of(file), "newer");
}

TEST_F(Outputs, LinkToNothingStaysAndItsFileIsMade) {
  const fs::path link = folder_.path() / "link";
  fs::create_symlink("second", link);
  fs::create_symlink("a.txt", folder_.path() / "second");
  EXPECT_THROW(write_file(link, "newer", {}), InputError);
  EXPECT_FALSE(fs::exists(folder_.path() / "a.txt"));
  write_file(link, "newer", {{}, true});
  EXPECT_TRUE(fs::is_symlink(link));
  EXPECT_FALSE(fs::is_symlink(folder_.path() / "a.txt"));
  EXPECT_EQ(content_of(folder_.path() / "a.txt"), "newer");
  fs::create_symlink("loop", folder_.path() / "loop");
  EXPECT_THROW(write_file(folder_.path() / "loop", "x", {{}, true}),
               InputError);
}

// While the work was done that was to be written.
TEST_F(Outputs, WhatCameBetweenStays) {
  const fs::path input = folder_.write("input.txt", "input");
  const fs::path place = folder_.path() / "a.txt";
  const auto come_between = [&](const OutputRule& rule, auto&& come) {
    fs::remove(place);
    OutputFile output(place, rule);
    output.stream() << "newer";
    come();
    EXPECT_THROW(output.commit(), InputError);
  };
  come_between({}, [&] { folder_.write("a.txt", "other"); });
  EXPECT_EQ(content_of(place), "other");
  come_between({}, [&] { fs::create_symlink("nothing", place); });
  EXPECT_TRUE(fs::is_symlink(place));
  for (const bool force : {false, true}) {
    const OutputRule rule{{input}, force};
    come_between(rule, [&] { fs::create_symlink("input.txt", place); });
    EXPECT_TRUE(fs::is_symlink(place));
    come_between(rule, [&] { fs::create_hard_link(input, place); });
    EXPECT_EQ(content_of(place), "input");
    EXPECT_THROW(write_file(place, "newer", rule), InputError);
  }
  EXPECT_EQ(content_of(input), "input");
  EXPECT_EQ(entries_of(folder_.path()), 2);
}

// The device that stands for a full disk.
TEST_F(Outputs, DevicesAreWrittenToAndFullOnesTold) {
  EXPECT_NO_THROW(write_file("/dev/null", "x", {}));
  EXPECT_TRUE(fs::is_character_file("/dev/null"));
  EXPECT_THROW(write_file("/dev/full", "x", {}), InputError);
}

TEST_F(Outputs, FolderComesWithAllItsFilesOrNotAtAll) {
  const fs::path target = folder_.path() / "new" / "test";
  {
    const OutputFolder output(target, {});
    output.write("a.txt", "a");
  }
  EXPECT_EQ(entries_of(folder_.path()), 0);
  OutputFolder output(target, {});
  output.write("a.txt", "a");
  output.write("b.txt", "b");
  EXPECT_FALSE(fs::exists(target));
  output.commit();
  EXPECT_EQ(content_of(target / "b.txt"), "b");
  EXPECT_EQ(entries_of(target), 2);
  EXPECT_EQ(entries_of(folder_.path()), 1);
}

// The name that its user knows, not that of the folder beside it.
TEST_F(Outputs, FolderNamesTheFileThatCouldNotBeWritten) {
  const fs::path target = folder_.path() / "test";
  const OutputFolder output(target, {});
  try {
    output.write("a.wav", [](const fs::path& file) {
      throw InputError("is full", file.string() + ":1", "try this");
    });
    FAIL();
  } catch (const InputError& error) {
    EXPECT_EQ(error.where(), (target / "a.wav").string() + ":1");
  }
}

// Of what is in it already, the rule decides file by file.
TEST_F(Outputs, FolderAsksItsRuleForEveryFile) {
  const fs::path input = folder_.write("input.txt", "input");
  folder_.write("a.txt", "older");
  const OutputFolder kept(folder_.path(), OutputRule{{input}, false});
  EXPECT_THROW(kept.write("a.txt", ""), InputError);
  const OutputFolder forced(folder_.path(), OutputRule{{input}, true});
  EXPECT_NO_THROW(forced.write("a.txt", ""));
  EXPECT_THROW(forced.write("input.txt", ""), InputError);
}

// What came between is found when all are brought in, and none is then.
TEST_F(Outputs, FolderThatMayNotBeWrittenStaysAsItWas) {
  {
    OutputFolder output(folder_.path(), {});
    output.write("a.txt", "newer");
    output.write("b.txt", "newer");
    folder_.write("b.txt", "older");
    EXPECT_THROW(output.commit(), InputError);
  }
  EXPECT_EQ(content_of(folder_.path() / "b.txt"), "older");
  EXPECT_EQ(entries_of(folder_.path()), 1);
}

// A folder in the place of one file stops all of them.
TEST_F(Outputs, FolderInTheWayOfAFileStopsTheOthers) {
  folder_.write("a.txt", "older");
  folder_.write("c.txt", "older");
  fs::create_directory(folder_.path() / "b.txt");
  const std::vector<FileContent> files{{folder_.path() / "a.txt", "newer"},
                                       {folder_.path() / "b.txt", "newer"},
                                       {folder_.path() / "c.txt", "newer"}};
  EXPECT_THROW(write_files(files, OutputRule{{}, true}), InputError);
  EXPECT_EQ(content_of(folder_.path() / "a.txt"), "older");
  EXPECT_EQ(content_of(folder_.path() / "c.txt"), "older");
  EXPECT_EQ(entries_of(folder_.path()), 3);
}

TEST_F(Outputs, FolderLeavesAPipeThatIsInTheWay) {
  const fs::path pipe = folder_.path() / "a.txt";
  ASSERT_EQ(::mkfifo(pipe.c_str(), 0600), 0);
  EXPECT_THROW(write_files({{pipe, "newer"}}, OutputRule{{}, true}),
               InputError);
  EXPECT_TRUE(fs::is_fifo(pipe));
}

TEST_F(Outputs, FilesOfAFolderKeepTheirRights) {
  const fs::path file = folder_.write("a.txt", "older");
  const fs::perms own = fs::perms::owner_read | fs::perms::owner_write;
  fs::permissions(file, own);
  write_files({{file, "newer"}}, OutputRule{{}, true});
  EXPECT_EQ(content_of(file), "newer");
  EXPECT_EQ(fs::status(file).permissions(), own);
}

TEST_F(Outputs, FileThatIsFinishedHasNotTakenItsPlace) {
  const fs::path file = folder_.write("a.txt", "older");
  {
    OutputFile output(file, {{}, true});
    output.stream() << "newer";
    output.finish();
    EXPECT_EQ(content_of(file), "older");
    output.commit();
  }
  EXPECT_EQ(content_of(file), "newer");
  OutputFile full("/dev/full", {});
  full.stream() << "x";
  EXPECT_THROW(full.finish(), InputError);
}

TEST_F(Outputs, FolderThatIsThereKeepsItsOtherFiles) {
  folder_.write("a.txt", "older");
  folder_.write("other.txt", "other");
  {
    OutputFolder output(folder_.path(), OutputRule{{}, true});
    output.write("a.txt", "newer");
    EXPECT_EQ(content_of(folder_.path() / "a.txt"), "older");
    output.commit();
  }
  EXPECT_EQ(content_of(folder_.path() / "a.txt"), "newer");
  EXPECT_EQ(content_of(folder_.path() / "other.txt"), "other");
  EXPECT_EQ(entries_of(folder_.path()), 2);
}

TEST_F(Outputs, FilesThatBelongTogetherAreAllThereOrNone) {
  const fs::path folder = folder_.path();
  write_files({{folder / "a.svg", "picture"}, {folder / "a.csv", "numbers"}},
              {});
  EXPECT_EQ(content_of(folder / "a.csv"), "numbers");
  EXPECT_THROW(
      write_files({{folder / "b.svg", "other"}, {folder / "a.csv", "other"}},
                  {}),
      InputError);
  EXPECT_EQ(content_of(folder / "a.csv"), "numbers");
  EXPECT_EQ(entries_of(folder), 2);
  EXPECT_THROW(write_files({{folder / "not" / "there", ""}}, {}), InputError);
  EXPECT_FALSE(fs::exists(folder / "not"));
}

}  // namespace
}  // namespace tapfit::acquisition
