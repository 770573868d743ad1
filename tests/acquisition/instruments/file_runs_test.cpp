// Which recordings of one test a file of arrays holds.
#include "acquisition/instruments/file_runs.hpp"

#include <gtest/gtest.h>

namespace tapfit::acquisition {
namespace {

using Arrays = std::vector<NamedArray>;

// Values that tell an array from others: its number, then what rises unevenly.
Eigen::VectorXd samples_like(int array, Eigen::Index count = 4) {
  Eigen::VectorXd values(count);
  for (Eigen::Index k = 0; k < count; ++k) {
    values[k] = static_cast<double>(k * k % 3);
  }
  values[0] = array;
  return values;
}

NamedArray array_like(const std::string& name,
                      int number,
                      Eigen::Index count = 4) {
  return {.name = name,
          .kind = NamedArray::Kind::Numbers,
          .values = samples_like(number, count)};
}
NamedArray several(const std::string& name, int first, int columns) {
  NamedArray array = array_like(name, first);
  array.values.conservativeResize(Eigen::NoChange, columns);
  for (int k = 1; k < columns; ++k) {
    array.values.col(k) = samples_like(first + k);
  }
  return array;
}
NamedArray text_of(const std::string& name, std::vector<std::string> texts) {
  NamedArray array{.name = name, .kind = NamedArray::Kind::Text};
  array.texts = std::move(texts);
  return array;
}

// "run: channel=number channel=number; run: ..."
std::string told(const FileRuns& read) {
  std::string text;
  for (const FileRun& run : read.runs) {
    if (!text.empty()) text += "; ";
    text += run.name + ":";
    for (const TimeRecord& record : run.records) {
      text += " " + record.name + "=" +
              std::to_string(static_cast<int>(record.values[0]));
    }
  }
  return text;
}

TEST(FileRuns, GroupsThatRepeatChannelsAreRuns) {
  // Listed as HDF5 does; run10 comes after run2.
  const Arrays arrays{array_like("run1/acc", 11),
                      array_like("run1/force", 10),
                      array_like("run10/acc", 31),
                      array_like("run10/force", 30),
                      array_like("run2/acc", 21),
                      array_like("run2/force", 20)};
  const FileRuns read = runs_of_arrays(arrays);
  EXPECT_EQ(told(read),
            "run1: acc=11 force=10; run2: acc=21 force=20; "
            "run10: acc=31 force=30");
  EXPECT_TRUE(read.left_out.empty());
  EXPECT_TRUE(read.doubt.empty());
}

TEST(FileRuns, HaveLengthsAndRatesOfTheirOwn) {
  const FileRuns read = runs_of_arrays({array_like("a/force", 1),
                                        text_of("a/force@unit", {"N"}),
                                        array_like("a/acc", 2),
                                        array_like("a@fs", 100, 1),
                                        array_like("b/force", 3, 7),
                                        text_of("b/force@unit", {"N"}),
                                        array_like("b/acc", 4, 7),
                                        array_like("b@fs", 200, 1)});
  EXPECT_EQ(told(read), "a: force=1 acc=2; b: force=3 acc=4");
  EXPECT_EQ(read.runs[1].records[1].values.size(), 7);
  EXPECT_EQ(read.runs[0].records[0].rate_hz, 100.0);
  EXPECT_EQ(read.runs[1].records[0].rate_hz, 200.0);
}

TEST(FileRuns, DeeperGroupsStructuresCellsAndKeys) {
  EXPECT_EQ(told(runs_of_arrays({array_like("test/run1/force", 1),
                                 array_like("test/run1/acc", 2),
                                 array_like("test/run2/force", 3),
                                 array_like("test/run2/acc", 4)})),
            "test/run1: force=1 acc=2; test/run2: force=3 acc=4");
  EXPECT_EQ(told(runs_of_arrays({array_like("m.force", 1),
                                 array_like("m.acc", 2),
                                 array_like("m(2).force", 3),
                                 array_like("m(2).acc", 4)})),
            "m: force=1 acc=2; m(2): force=3 acc=4");
  EXPECT_EQ(told(runs_of_arrays({array_like("force{1}", 1),
                                 array_like("force{2}", 3, 5),
                                 array_like("acc{1}", 2),
                                 array_like("acc{2}", 4, 5)})),
            "{1}: force=1 acc=2; {2}: force=3 acc=4");
  EXPECT_EQ(told(runs_of_arrays({array_like("run1_hammer", 1),
                                 array_like("run1_acc_x", 2),
                                 array_like("run2_hammer", 3),
                                 array_like("run2_acc_x", 4)})),
            "run1: hammer=1 acc_x=2; run2: hammer=3 acc_x=4");
  EXPECT_EQ(told(runs_of_arrays({array_like("hammer_run1", 1),
                                 array_like("acc_run1", 2),
                                 array_like("hammer_run2", 3),
                                 array_like("acc_run2", 4)})),
            "run1: hammer=1 acc=2; run2: hammer=3 acc=4");
}

TEST(FileRuns, AxisOfRunsOrOfChannels) {
  EXPECT_EQ(
      told(runs_of_arrays({several("force", 1, 2), several("acc", 3, 2)})),
      "1: force=1 acc=3; 2: force=2 acc=4");
  EXPECT_EQ(
      told(runs_of_arrays({several("run1", 1, 2), several("run2", 3, 2)})),
      "run1: channel 1=1 channel 2=2; run2: channel 1=3 channel 2=4");
  // Three accelerations beside one force are channels.
  EXPECT_EQ(
      told(runs_of_arrays({array_like("force", 1), several("acc", 2, 3)})),
      ": force=1 acc:1=2 acc:2=3 acc:3=4");
}

TEST(FileRuns, SensorsWithThreeAxesAreNone) {
  Arrays arrays{array_like("hammer/force", 1)};
  for (int sensor = 1; sensor <= 2; ++sensor) {
    for (const char* axis : {"x", "y", "z"}) {
      arrays.push_back(
          array_like("acc" + std::to_string(sensor) + "/" + axis, 2 * sensor));
    }
  }
  EXPECT_EQ(runs_of_arrays(arrays).runs.size(), 1U);
  arrays.push_back(text_of("hammer/force@unit", {"N"}));
  const FileRuns read = runs_of_arrays(arrays);
  EXPECT_EQ(read.runs.size(), 1U);
  EXPECT_EQ(read.runs[0].records.size(), 7U);
  EXPECT_TRUE(read.doubt.empty());
}

TEST(FileRuns, SayWhereItCannotBeTold) {
  const FileRuns groups = runs_of_arrays({array_like("a/1", 1),
                                          array_like("a/2", 2),
                                          array_like("b/1", 3),
                                          array_like("b/2", 4)});
  EXPECT_EQ(groups.runs.size(), 1U);
  EXPECT_NE(groups.doubt.find("cannot be told"), std::string::npos);
  const FileRuns columns =
      runs_of_arrays({several("a", 1, 2), several("b", 3, 2)});
  EXPECT_NE(columns.doubt.find("cannot be told"), std::string::npos);
  // A sensor that was called by its point, which changed.
  const FileRuns points = runs_of_arrays({array_like("a/force", 1),
                                          text_of("a/force@unit", {"N"}),
                                          array_like("a/3Z+", 2),
                                          array_like("b/force", 3),
                                          text_of("b/force@unit", {"N"}),
                                          array_like("b/4Z+", 4)});
  EXPECT_NE(points.doubt.find("otherwise no channels of the same names"),
            std::string::npos);
}

TEST(FileRuns, NameWhatIsLeftOut) {
  const FileRuns runs = runs_of_arrays({array_like("run1/force", 1),
                                        array_like("run1/acc", 2),
                                        array_like("run1/mic", 5),
                                        array_like("run2/force", 3),
                                        array_like("run2/acc", 4)});
  EXPECT_EQ(told(runs), "run1: force=1 acc=2; run2: force=3 acc=4");
  ASSERT_EQ(runs.left_out.size(), 1U);
  EXPECT_EQ(runs.left_out[0], "\"run1/mic\" is left out: not every run has it");
  const FileRuns lengths = runs_of_arrays({array_like("force", 1, 20),
                                           array_like("a", 2, 20),
                                           array_like("b", 3, 19),
                                           array_like("gains", 4, 1)});
  ASSERT_EQ(lengths.left_out.size(), 1U);
  EXPECT_EQ(lengths.left_out[0],
            "\"b\" is left out: it holds 19 samples, the other channels 20");
}

}  // namespace
}  // namespace tapfit::acquisition
