// Files that hold several runs of one test become as many recordings.
#include "acquisition/bundle/recording.hpp"
#include "acquisition/bundle/run_reader.hpp"
#include "acquisition/foundation/input_error.hpp"
#include "acquisition/import/propose_import.hpp"
#include "tests/acquisition/support/hdf5_writer.hpp"
#include "tests/acquisition/support/mat_text.hpp"
#include "tests/acquisition/support/npy_text.hpp"
#include "tests/acquisition/support/tdms_text.hpp"
#include "tests/acquisition/support/temporary_folder.hpp"

#include <gtest/gtest.h>

#include <algorithm>

namespace tapfit::acquisition {
namespace {

namespace fs = std::filesystem;

// Two runs of 60 and 50 samples: a pulse where the hammer is, and a response
// that swings back.
Eigen::VectorXd force_of(int run) {
  Eigen::VectorXd force = Eigen::VectorXd::Zero(run == 1 ? 60 : 50);
  force[5 * run] = 8.0 * run;
  return force;
}
Eigen::VectorXd acceleration_of(int run) {
  Eigen::VectorXd motion = 0.25 * force_of(run);
  motion[5 * run + 1] = -motion[5 * run];
  return motion;
}

std::vector<double> as_list(const Eigen::VectorXd& values) {
  return {values.begin(), values.end()};
}

std::string tdms_of_two_runs() {
  testing::TdmsBytes metadata;
  testing::TdmsBytes raw;
  metadata.add(std::uint32_t{4});
  for (const int run : {1, 2}) {
    for (const char* channel : {"force", "acc"}) {
      const Eigen::VectorXd values = std::string(channel) == "force"
                                         ? force_of(run)
                                         : acceleration_of(run);
      testing::tdms_object(
          metadata,
          "/'run" + std::to_string(run) + "'/'" + channel + "'",
          10,
          static_cast<std::uint64_t>(values.size()));
      metadata.add(std::uint32_t{1});
      testing::tdms_property(metadata, "wf_increment", 1.0 / 512.0);
      for (const double value : values) raw.add(value);
    }
  }
  return testing::tdms_segment(
      testing::TdmsMetadata | testing::TdmsNewList | testing::TdmsRawData,
      metadata,
      raw);
}

class ImportRuns : public ::testing::Test {
 protected:
  testing::TemporaryFolder folder_;

  ImportOptions options_for(const fs::path& file) {
    ImportOptions options;
    options.files = {{file, {}}};
    options.folder = folder_.path() / "bundle";
    return options;
  }
  // Each run holds its own blow and what follows from it.
  void expect_two_runs(const ImportOptions& options, int second_length = 50) {
    const TestBundle bundle =
        import_recordings(propose_import(options).options);
    ASSERT_EQ(bundle.runs.size(), 2U);
    EXPECT_EQ(bundle.channels.size(), 2U);
    for (const int run : {1, 2}) {
      const Recording recording =
          read_recordings(bundle).at(static_cast<std::size_t>(run - 1));
      const Eigen::Index length = run == 1 ? 60 : second_length;
      ASSERT_EQ(recording.samples.rows(), length);
      EXPECT_EQ(recording.sample_rate_hz, 512.0);
      EXPECT_EQ(recording.samples(5 * run, 0), 8.0 * run);
      EXPECT_EQ(recording.samples(5 * run, 1), 2.0 * run);
    }
    fs::remove_all(bundle.folder);
  }
};

TEST_F(ImportRuns, OfEachKindOfFile) {
  const fs::path hdf5 = folder_.path() / "two.h5";
  {
    testing::Hdf5Writer writer(hdf5);
    for (const int run : {1, 2}) {
      const std::string group = "run" + std::to_string(run);
      writer.group(group);
      writer.numbers(group + "/acc", acceleration_of(run));
      writer.numbers(group + "/force", force_of(run));
    }
    writer.numbers("fs", Eigen::MatrixXd::Constant(1, 1, 512.0));
  }
  expect_two_runs(options_for(hdf5));
  expect_two_runs(options_for(folder_.write("two.tdms", tdms_of_two_runs())));
  std::vector<std::pair<std::string, std::string>> keys{
      {"fs.npy", testing::npy({512.0})}};
  std::string matlab =
      testing::mat4_variable("fs", Eigen::MatrixXd::Constant(1, 1, 512.0));
  for (const int run : {1, 2}) {
    const std::string group = "run" + std::to_string(run);
    keys.emplace_back(group + "/force.npy",
                      testing::npy(as_list(force_of(run))));
    keys.emplace_back(group + "/acc.npy",
                      testing::npy(as_list(acceleration_of(run))));
    matlab += testing::mat4_variable(group + "_force", force_of(run)) +
              testing::mat4_variable(group + "_acc", acceleration_of(run));
  }
  expect_two_runs(
      options_for(folder_.write("two.npz", testing::zip(keys, false))));
  expect_two_runs(options_for(folder_.write("two.mat", matlab)));
}

TEST_F(ImportRuns, OfAnAxis) {
  Eigen::MatrixXd force = Eigen::MatrixXd::Zero(60, 2);
  Eigen::MatrixXd motion = force;
  force.col(0) = force_of(1);
  force.col(1).head(50) = force_of(2);
  motion.col(0) = acceleration_of(1);
  motion.col(1).head(50) = acceleration_of(2);
  const std::string matlab =
      testing::mat4_variable("fs", Eigen::MatrixXd::Constant(1, 1, 512.0)) +
      testing::mat4_variable("force", force.transpose()) +
      testing::mat4_variable("acc", motion.transpose());
  expect_two_runs(options_for(folder_.write("runs.mat", matlab)), 60);
}

TEST_F(ImportRuns, OneAloneByItsFullName) {
  ImportOptions options =
      options_for(folder_.write("two.tdms", tdms_of_two_runs()));
  options.hammer.column = "run2/force";
  options.hammer.channel = "hammer";
  options.hammer.quantity = Quantity::Force;
  options.hammer.dof = {1, 3, 1};
  ImportChannel sensor;
  sensor.column = "run2/acc";
  sensor.channel = "acc";
  sensor.dof = {2, 3, 1};
  options.sensors = {sensor};
  const TestBundle bundle = import_recordings(options);
  ASSERT_EQ(bundle.runs.size(), 1U);
  EXPECT_EQ(read_recordings(bundle).at(0).samples(10, 1), 4.0);
  fs::remove_all(bundle.folder);
  options.sensors[0].column = "run1/acc";
  EXPECT_THROW((void)import_recordings(options), InputError);
}

TEST_F(ImportRuns, IsRefusedWhereItCannotBeTold) {
  std::vector<std::pair<std::string, std::string>> keys{
      {"fs.npy", testing::npy({512.0})}};
  for (const char* group : {"left", "right"}) {
    keys.emplace_back(std::string(group) + "/1.npy",
                      testing::npy(as_list(force_of(1))));
    keys.emplace_back(std::string(group) + "/2.npy",
                      testing::npy(as_list(force_of(1))));
  }
  try {
    (void)propose_import(
        options_for(folder_.write("x.npz", testing::zip(keys, false))));
    FAIL() << "taken";
  } catch (const InputError& error) {
    const std::string text = error.what();
    EXPECT_NE(text.find("cannot be told"), std::string::npos) << text;
    EXPECT_NE(text.find("--sensor COLUMN@POINT"), std::string::npos) << text;
  }
}

TEST_F(ImportRuns, ChannelsOfOtherLengthAreNamed) {
  const fs::path file = folder_.write(
      "short.npz",
      testing::zip({{"fs.npy", testing::npy({512.0})},
                    {"force.npy", testing::npy(as_list(force_of(1)))},
                    {"acc.npy", testing::npy(as_list(acceleration_of(1)))},
                    {"late.npy", testing::npy(as_list(acceleration_of(2)))}},
                   false));
  const TestBundle bundle =
      import_recordings(propose_import(options_for(file)).options);
  EXPECT_TRUE(std::ranges::any_of(bundle.warnings, [](const std::string& note) {
    return note.find("\"late\" is left out: it holds 50 samples") !=
           std::string::npos;
  }));
}

}  // namespace
}  // namespace tapfit::acquisition
