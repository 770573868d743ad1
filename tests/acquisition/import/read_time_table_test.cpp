// MATLAB, SEP-005 and universal files as sources of a bundle.
#include "acquisition/import/read_time_table.hpp"

#include "acquisition/bundle/recording.hpp"
#include "acquisition/bundle/run_reader.hpp"
#include "acquisition/foundation/input_error.hpp"
#include "acquisition/import/import_recordings.hpp"
#include "acquisition/readers/mat_file.hpp"
#include "tests/acquisition/support/mat_text.hpp"
#include "tests/acquisition/support/temporary_folder.hpp"
#include "tests/acquisition/support/uff_text.hpp"

#include <gtest/gtest.h>

namespace tapfit::acquisition {
namespace {

namespace fs = std::filesystem;

class TimeTables : public ::testing::Test {
 protected:
  testing::TemporaryFolder folder_;

  std::string refusal(const fs::path& file,
                      const std::vector<std::string>& columns) {
    try {
      (void)read_time_table(file, columns, {});
    } catch (const InputError& error) {
      return error.what();
    }
    return "accepted";
  }

  fs::path mat() {
    Eigen::MatrixXd wide(2, 3);
    wide << 1, 2, 3, 4, 5, 6;
    return folder_.write(
        "test.mat",
        testing::mat4_variable("force", Eigen::Vector3d(0, 7, -1)) +
            testing::mat4_variable("acc", wide) +
            testing::mat4_variable("fs", Eigen::VectorXd::Constant(1, 64.0)));
  }
};

bool has(const std::string& text, const std::string& part) {
  return text.find(part) != std::string::npos;
}

TEST_F(TimeTables, MatVariablesByName) {
  const fs::path file = mat();
  const TimeTable table = read_time_table(file, {"force", "acc:2"}, {});
  Eigen::MatrixXd expected(3, 2);
  expected << 0, 4, 7, 5, -1, 6;
  EXPECT_EQ(table.values, expected);
  EXPECT_EQ(number_of(read_mat_arrays(file), "fs", file), 64.0);
  EXPECT_EQ(table.rate_hz, 64.0) << "its variable fs";
  EXPECT_FALSE(says_rate(file));
}

// What is taken into memory whole must fit there.
TEST_F(TimeTables, TextBeyondItsSizeIsRefused) {
  for (const char* name : {"a.csv", "a.json"}) {
    const fs::path file = folder_.write(name, "");
    fs::resize_file(file, std::uintmax_t{1} << 40U);  // sparse
    EXPECT_NE(refusal(file, {"1"}).find("the most that is read"),
              std::string::npos)
        << name;
  }
}

TEST_F(TimeTables, MatRefusesWithWhatIsThere) {
  const fs::path file = mat();
  EXPECT_TRUE(has(refusal(file, {"gone"}), "force, acc, fs"));
  EXPECT_TRUE(has(refusal(file, {"acc"}), "has 2 columns"));
  EXPECT_TRUE(has(refusal(file, {"acc:3"}), "has 2 columns"));
  EXPECT_TRUE(has(refusal(file, {"force", "fs"}), "has 1 samples"));
  EXPECT_TRUE(has(refusal(folder_.write("no.mat", "not one"), {"x"}),
                  "cannot be read as a MATLAB file"));
  EXPECT_THROW((void)number_of(read_mat_arrays(file), "force", file),
               InputError);
}

// Version 4 has no check of its own: values that are not there would be zeros.
TEST_F(TimeTables, MatRefusesCutFiles) {
  const std::string whole =
      testing::mat4_variable("force", Eigen::VectorXd::Ones(100));
  for (const std::size_t bytes : {19U, 25U, 400U, 824U}) {
    const fs::path file = folder_.write("cut.mat", whole.substr(0, bytes));
    EXPECT_NE(refusal(file, {"force"}), "accepted") << bytes;
  }
  EXPECT_TRUE(
      has(refusal(folder_.write("cut.mat", whole.substr(0, 400)), {"force"}),
          "806 bytes are announced, 380 are there"));
  std::string tall = whole;
  tall.replace(4, 4, "\xff\xff\xff\x0f");  // 268 million rows
  EXPECT_TRUE(
      has(refusal(folder_.write("tall.mat", tall), {"force"}), "ends early"));
}

// A structure in a compressed version 5 file that others published.
TEST_F(TimeTables, MatReadsPublishedFiles) {
  const fs::path file =
      TAPFIT_SOURCE_DIR "/../shared/data/pedestrian-bridge/ExpModeInfo_FEM.mat";
  if (!fs::exists(file)) GTEST_SKIP() << file << " is not there";
  const std::string refused = refusal(file, {"no_such_variable"});
  EXPECT_TRUE(has(refused, "use one of")) << refused;
}

TEST_F(TimeTables, Sep005SignalsByNameOrNumber) {
  const fs::path file = folder_.write("rec.json", R"([
    {"name": "hammer", "data": [0, 3.5, 0], "unit_str": "N", "fs": 128},
    {"name": "acc1", "data": [1, 2, 3], "unit_str": "g",
     "time": [0.5, 0.5078125, 0.515625]}])");
  const TimeTable table = read_time_table(file, {"acc1", "1"}, {});
  EXPECT_EQ(table.rate_hz, 128.0);
  EXPECT_EQ(table.values(1, 0), 2.0);
  EXPECT_EQ(table.values(1, 1), 3.5);
  EXPECT_EQ(table.units, (std::vector<std::string>{"g", "N"}));
}

TEST_F(TimeTables, Sep005RefusesWithThePlace) {
  const auto of = [&](const std::string& text) {
    return refusal(folder_.write("rec.json", text), {"1", "2"});
  };
  EXPECT_TRUE(has(of("[]"), "no list of signals"));
  EXPECT_TRUE(has(of("[{]"), "rec.json"));
  EXPECT_TRUE(has(of(R"([{"data": [1, "x"], "fs": 1}])"), "[0].data[1]"));
  for (const char* word : {"NaN", "Infinity", "-Infinity"}) {
    const std::string refused =
        of(fmt::format(R"([{{"data": [1, 2, {}, 4], "fs": 1}}])", word));
    EXPECT_TRUE(has(refused, "value 3 of a list is no finite number"))
        << refused;
  }
  EXPECT_TRUE(has(of(R"([{"data": [1, 2, 1e999], "fs": 1}])"), "overflow"));
  EXPECT_TRUE(has(of(R"([{"data": [1, 2]}])"), "[0].time"));
  EXPECT_TRUE(has(of(R"([{"data": [1, 2], "fs": 0}])"), "[0].fs"));
  EXPECT_TRUE(has(of(R"([{"data": [1, 2], "fs": 1},
                         {"data": [1, 2], "fs": 2}])"),
                  "[1].fs"));
  EXPECT_TRUE(has(of(R"([{"data": [1, 2], "fs": 1},
                         {"data": [1], "fs": 1}])"),
                  "1 samples"));
  EXPECT_TRUE(
      has(of(R"([{"data": [1, 2, 3], "time": [0, 1, 9]}])"), "[0].time[1]"));
  EXPECT_TRUE(has(of(R"([{"data": [1], "fs": 1}])"), "no signal \"2\""));
}

ImportOptions options_for(const fs::path& file, const fs::path& folder) {
  ImportOptions options;
  options.files = {{file, {}}};
  options.hammer = {.column = "hammer",
                    .channel = "hammer",
                    .quantity = Quantity::Force,
                    .dof = {3, 3, 1}};
  options.sensors = {{.column = "acc1", .channel = "acc1", .dof = {12, 3, 1}}};
  options.folder = folder;
  return options;
}

TEST_F(TimeTables, ImportTakesUnitAndRateFromTheFile) {
  const fs::path file = folder_.write("rec.json", R"([
    {"name": "hammer", "data": [0, 2, 0], "unit_str": "kN", "fs": 128},
    {"name": "acc1", "data": [1, 2, 3], "unit_str": "g", "fs": 128}])");
  const TestBundle bundle =
      import_recordings(options_for(file, folder_.path() / "bundle"));
  const Recording recording = read_recording(bundle, bundle.runs.at(0));
  EXPECT_EQ(recording.sample_rate_hz, 128.0);
  EXPECT_DOUBLE_EQ(recording.samples(1, 0), 2000.0);
  EXPECT_DOUBLE_EQ(recording.samples(2, 1), 3.0 * 9.80665);
}

TEST_F(TimeTables, ImportTakesTheRateFromAMatVariable) {
  ImportOptions options = options_for(mat(), folder_.path() / "bundle");
  options.hammer.column = "force";
  options.sensors[0].column = "acc:1";
  options.rate_variable = "fs";
  const TestBundle bundle = import_recordings(options);
  const Recording recording = read_recording(bundle, bundle.runs.at(0));
  EXPECT_EQ(recording.sample_rate_hz, 64.0);
  EXPECT_DOUBLE_EQ(recording.samples(1, 0), 7.0);
  EXPECT_DOUBLE_EQ(recording.samples(2, 1), 3.0);
}

TEST_F(TimeTables, ImportTakesTimeRecordsOfUniversalFiles) {
  const fs::path file = folder_.write(
      "rec.uff",
      testing::uff_ascii({.axis = 13, .unit = "N", .values = {0, 4, 0}}) +
          testing::uff_ascii({.unit = "g", .values = {1, 2, 3}}));
  ImportOptions options = options_for(file, folder_.path() / "bundle");
  options.hammer.column = "1";
  options.sensors[0].column = "2";
  const TestBundle bundle = import_recordings(options);
  const Recording recording = read_recording(bundle, bundle.runs.at(0));
  EXPECT_EQ(recording.sample_rate_hz, 1024.0);
  EXPECT_DOUBLE_EQ(recording.samples(1, 0), 4.0);
  EXPECT_DOUBLE_EQ(recording.samples(2, 1), 3.0 * 9.80665);
  EXPECT_TRUE(has(refusal(file, {"3"}), "number from 1 to 2"));
}

// Nodes only (dataset 15).
TEST_F(TimeTables, AUniversalFileWithoutTimeRecordsSaysSo) {
  const fs::path file = folder_.write(
      "nodes.uff",
      "    -1\n    15\n"
      "         1         0         0         8  0.0  0.0  0.0\n    -1\n");
  const std::string said = refusal(file, {"1"});
  EXPECT_NE(said.find("no time records"), std::string::npos) << said;
}

}  // namespace
}  // namespace tapfit::acquisition
