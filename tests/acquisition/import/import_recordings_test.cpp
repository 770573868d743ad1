#include "acquisition/import/import_recordings.hpp"

#include "acquisition/bundle/run_reader.hpp"
#include "acquisition/foundation/input_error.hpp"
#include "acquisition/hits/find_hits.hpp"
#include "acquisition/hits/hits.hpp"
#include "acquisition/import/read_time_table.hpp"
#include "tests/acquisition/support/temporary_folder.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>

namespace tapfit::acquisition {
namespace {

class Csv : public ::testing::Test {
 protected:
  Eigen::MatrixXd read(const std::string& text,
                       const std::vector<std::string>& columns) {
    return read_csv_columns(folder_.write("a.csv", text), columns, {});
  }
  std::string refusal(const std::string& text,
                      const std::vector<std::string>& columns) {
    try {
      (void)read(text, columns);
    } catch (const InputError& error) {
      return error.where();
    }
    return "accepted";
  }
  testing::TemporaryFolder folder_;
};

TEST_F(Csv, ReadsEverySeparatorAndDecimalMark) {
  Eigen::MatrixXd expected(3, 2);
  expected << 0.5, 1e-3, -2.25, 20.0, 3.0, 0.0;
  const std::vector<std::string> columns{"a", "b"};
  EXPECT_EQ(read("t,a,b\n0,0.5,1e-3\n1,-2.25,20\n2,3,0\n", columns), expected);
  EXPECT_EQ(
      read("t;a;b\r\n0;0,5;0,001\r\n1;-2,25;20,0\r\n2;3,0;0\r\n", columns),
      expected);
  EXPECT_EQ(read("t\ta\tb\n0\t.5\t1E-3\n1\t-2.25\t2e1\n2\t+3\t0\n\n", columns),
            expected);
  EXPECT_EQ(
      read("\"t\",\"a\",\"b\"\n0,\"0.5\",1e-3\n1,-2.25,20\n2,3,0", {"2", "3"}),
      expected);
}

// As a proposal shows it, and as it stands there.
TEST_F(Csv, FindsAColumnWithOrWithoutItsUnit) {
  const std::string text = "t [s],a [g],b (mV)\n0,1,2\n1,3,4\n2,5,6\n";
  const Eigen::Vector3d expected(1, 3, 5);
  EXPECT_EQ(read(text, {"a"}), expected);
  EXPECT_EQ(read(text, {"a [g]"}), expected);
  EXPECT_EQ(read_csv_table(folder_.path() / "a.csv", {"b", "a"}, {}).units,
            (std::vector<std::string>{"mV", "g"}));
}

TEST_F(Csv, FindsTheNumbersBelowALoggersHeader) {
  const std::string text =
      "\"ID No.\",\"PCD-400A\"\r\n\"Sampling Rate(Hz)\",50\r\n"
      "\"CH No.\",\"CH2\",\"CH8\"\r\n\"Range\",2000,5\r\n"
      "\"Unit\",\"cm/s2\",\"V\"\r\n0.00,1,2,,Mass,2.5,kg\r\n0.02,3,4,,\r\n";
  Eigen::MatrixXd expected(2, 2);
  expected << 2, 1, 4, 3;
  EXPECT_EQ(read(text, {"CH8", "CH2"}), expected);
}

TEST_F(Csv, TakesFortransExponentsAndOldLineEnds) {
  Eigen::MatrixXd expected(2, 2);
  expected << 1500.0, -0.25, 2.0, 0.0;
  const std::vector<std::string> columns{"a", "b"};
  EXPECT_EQ(read("t,a,b\n0,1.5D+03,-2.5d-1\n1,2,0D0\n", columns), expected);
  EXPECT_EQ(read("t,a,b\r0,1500,-.25\r1,2,0\r", columns), expected);
}

TEST_F(Csv, SaysThatATextIsUtf16) {
  std::string wide("\xff\xfe");
  for (const char c : std::string("t,a\n0,1\n1,2\n")) wide += {c, '\0'};
  for (const std::string& text : {wide, wide.substr(2)}) {
    try {
      (void)read(text, {"a"});
      FAIL();
    } catch (const InputError& error) {
      EXPECT_NE(std::string(error.what()).find("UTF-16"), std::string::npos)
          << error.what();
    }
  }
}

TEST_F(Csv, NamesLineAndColumnOfAFault) {
  const std::string name = (folder_.path() / "a.csv").string();
  EXPECT_EQ(refusal("t,a\n0,1\n1,2\n2,x\n", {"a"}), name + ":4:2");
  EXPECT_EQ(refusal("t,a\n0,1\n1,2\n2\n", {"a"}), name + ":4:2");
  EXPECT_EQ(refusal("t,a\n0,1\n1,nan\n2,3\n3,3\n", {"a"}), name + ":3:2");
}

TEST_F(Csv, RefusesMissingColumnsAndEmptyFiles) {
  const std::string name = (folder_.path() / "a.csv").string();
  EXPECT_EQ(refusal("t,a\n0,1\n1,2\n", {"b"}), name);
  EXPECT_EQ(refusal("t,a\n0,1\n1,2\n", {"3"}), name);
  EXPECT_EQ(refusal("", {"1"}), name);
  EXPECT_EQ(refusal("no numbers here\n", {"1"}), name);
}

ImportOptions simple(const testing::TemporaryFolder& folder) {
  ImportOptions options;
  options.hammer = {.column = "f",
                    .channel = "hammer",
                    .quantity = Quantity::Force,
                    .unit = "N",
                    .volts_per_unit = 0.5,
                    .dof = {7, 3, 1}};
  options.sensors = {{.column = "a",
                      .channel = "acc1",
                      .unit = "cm/s^2",
                      .flip_sign = true,
                      .dof = {2, 1, 1}}};
  options.folder = folder.path() / "bundle";
  return options;
}

// Where the command line names no unit, the header's counts.
TEST_F(Csv, HoldsTheUnitsOfItsHeader) {
  ImportOptions options = simple(folder_);
  options.hammer.volts_per_unit = {};
  options.hammer.unit = options.sensors[0].unit = "";
  options.files = {
      {folder_.write("one.csv", "t,f [kN],a [g]\n0,1,3\n.01,2,-400\n"), {}}};
  const TestBundle bundle = import_recordings(options);
  EXPECT_EQ(bundle.channels[0].unit, "kN");
  EXPECT_EQ(bundle.channels[1].unit, "g");
}

TEST_F(Csv, BecomesABundleWithPhysicalValues) {
  ImportOptions options = simple(folder_);
  options.files = {
      {folder_.write("one.csv", "t,f,a\n0,1,3\n.01,2,-400\n"), {}},
      {folder_.write("two.csv", "t,f,a\n0,7,3\n.01,2,1\n"), Dof{9, 3, -1}}};
  const TestBundle bundle = import_recordings(options);
  EXPECT_EQ(bundle.runs[0].hammer.dof, (Dof{7, 3, 1}));
  EXPECT_EQ(bundle.runs[1].hammer.dof, (Dof{9, 3, -1}));
  const std::vector<Recording> recordings = read_recordings(bundle);
  EXPECT_EQ(recordings[0].sample_rate_hz, 100.0);
  // Force: volts / 0.5 V/N. Acceleration: cm/s^2, sign turned. Scaling is by
  // powers of two, so only the unit's factor rounds.
  EXPECT_DOUBLE_EQ(recordings[0].samples(1, 0), 4.0);
  EXPECT_DOUBLE_EQ(recordings[0].samples(1, 1), 4.0);
  EXPECT_DOUBLE_EQ(recordings[1].samples(0, 0), 14.0);
  for (const bool force : {false, true}) {
    options.rule.force = force;
    EXPECT_THROW(import_recordings(options), InputError) << "a test is there";
  }
}

TEST_F(Csv, OnlySoundFilesThatTheRuleLetsAreReplaced) {
  ImportOptions options = simple(folder_);
  options.files = {
      {folder_.write("one.csv", "t,f,a\n0,1,3\n.01,2,-400\n"), {}}};
  std::filesystem::create_directory(options.folder);
  const auto sound = options.folder / "one.wav";
  std::ofstream(sound) << "measured";
  EXPECT_THROW(import_recordings(options), InputError);
  options.rule = {{sound}, true};
  EXPECT_THROW(import_recordings(options), InputError);
  EXPECT_EQ(std::filesystem::file_size(sound), 8U);
  options.rule = {{}, true};
  EXPECT_NO_THROW(import_recordings(options));
  EXPECT_GT(std::filesystem::file_size(sound), 8U);
}

// Hammer and sensor of one column have one name, which no test.json may have.
TEST_F(Csv, ABundleThatNoCommandCouldReadIsNotWritten) {
  ImportOptions options = simple(folder_);
  options.files = {
      {folder_.write("one.csv", "t,f,a\n0,1,3\n.01,2,-400\n"), {}}};
  options.sensors[0].column = options.hammer.column;
  options.sensors[0].channel = options.hammer.channel;
  EXPECT_THROW(import_recordings(options), InputError);
  EXPECT_FALSE(std::filesystem::exists(options.folder));
}

TEST_F(Csv, NamesColumnsThatAreZeroThroughout) {
  ImportOptions options = simple(folder_);
  options.files = {{folder_.write("one.csv", "t,f,a\n0,1,3\n.01,2,-400\n"), {}},
                   {folder_.write("two.csv", "t,f,a\n0,7,0\n.01,2,0\n"), {}}};
  const TestBundle bundle = import_recordings(options);
  ASSERT_EQ(bundle.warnings.size(), 1U);
  EXPECT_NE(bundle.warnings[0].find("two.csv: column \"a\" (acc1) is zero"),
            std::string::npos)
      << bundle.warnings[0];
}

TEST_F(Csv, MissesAFileBeforeTheFirstIsRead) {
  ImportOptions options = simple(folder_);
  options.files = {{folder_.write("broken.csv", "t,f,a\n0,1,x\n"), {}},
                   {folder_.path() / "gone.csv", {}}};
  try {
    import_recordings(options);
    FAIL();
  } catch (const InputError& error) {
    EXPECT_EQ(error.where(), (folder_.path() / "gone.csv").string());
  }
}

TEST_F(Csv, RefusesUnevenTimeAndOddRates) {
  ImportOptions options = simple(folder_);
  options.files = {
      {folder_.write("gap.csv", "t,f,a\n0,1,3\n1,2,4\n2,2,4\n9,2,4\n"), {}}};
  try {
    import_recordings(options);
    FAIL();
  } catch (const InputError& error) {
    // Where the gap is, not where a line through the ends is left.
    EXPECT_NE(std::string(error.what()).find("from row 3 "), std::string::npos)
        << error.what();
  }
  options.files = {
      {folder_.write("odd.csv", "t,f,a\n0,1,3\n.08,2,4\n.16,2,4\n"), {}}};
  EXPECT_THROW(import_recordings(options), InputError);
  options.sample_rate_hz = 12.0;
  EXPECT_NO_THROW(import_recordings(options));
}

// 205 Hz for 204.8 Hz would put every frequency off by 0.1 %.
TEST_F(Csv, AFractionalRateIsNotRounded) {
  ImportOptions options = simple(folder_);
  std::string table = "t,f,a\n";
  for (int i = 0; i < 100; ++i) {
    table += fmt::format("{:.6f},{},{}\n", i / 204.8, i % 7, i % 5);
  }
  const auto refused = [&](const std::filesystem::path& file) {
    options.files = {{file, {}}};
    try {
      (void)import_recordings(options);
    } catch (const InputError& error) {
      EXPECT_NE(std::string(error.what()).find("204.8"), std::string::npos)
          << error.what();
      return true;
    }
    return false;
  };
  EXPECT_TRUE(refused(folder_.write("times.csv", table)));
  const auto signals = [](const std::string& rate) {
    return fmt::format(
        R"([{{"name": "f", "data": [1, 2, 3], "unit_str": "N", {0}}},
            {{"name": "a", "data": [1, 2, 4], "unit_str": "g", {0}}}])",
        rate);
  };
  EXPECT_TRUE(refused(folder_.write("fs.json", signals("\"fs\": 204.8"))));
  EXPECT_TRUE(refused(folder_.write(
      "time.json", signals("\"time\": [0, 0.0048828125, 0.009765625]"))));
  options.sample_rate_hz = 204.8;
  EXPECT_TRUE(refused(folder_.write("rate.csv", table)));
}

TEST_F(Csv, TimesPrintedWithFewDigitsGiveTheWholeRate) {
  ImportOptions options = simple(folder_);
  std::string rounded = "t,f,a\n";
  std::string multiples = rounded;
  for (int i = 0; i < 101; ++i) {
    rounded += fmt::format("{:.4f},{},{}\n", i / 1024.0, i % 7, i % 5);
    multiples += fmt::format("{:.7f},{},{}\n", 0.0004883 * i, i % 7, i % 5);
  }
  // The last time is 0.0977 for 0.09766: 1023.54 Hz.
  options.files = {{folder_.write("rounded.csv", rounded), {}}};
  EXPECT_EQ(read_recordings(import_recordings(options))[0].sample_rate_hz,
            1024.0);
  options.folder += "-2";
  options.files = {{folder_.write("multiples.csv", multiples), {}}};
  const TestBundle bundle = import_recordings(options);
  EXPECT_EQ(read_recordings(bundle)[0].sample_rate_hz, 2048.0);
  ASSERT_EQ(bundle.warnings.size(), 1U);
  EXPECT_NE(bundle.warnings[0].find("2047.9214 Hz; 2048 Hz are taken"),
            std::string::npos)
      << bundle.warnings[0];
}

TEST_F(Csv, AnImportThatIsStoppedLeavesNothing) {
  ImportOptions options = simple(folder_);
  options.files = {{folder_.write("a.csv", "t,f,a\n0,1,3\n.01,2,-4\n"), {}}};
  std::stop_source stop;
  // At each of its steps, until there are no more.
  for (int step = 0; step < 20; ++step) {
    stop = {};
    int passed = 0;
    const Progress progress{[&](std::string_view, double) {
                              if (passed++ == step) stop.request_stop();
                            },
                            stop.get_token()};
    try {
      (void)import_recordings(options, progress);
      EXPECT_GE(step, 2);
      return;
    } catch (const Stopped&) {
      EXPECT_FALSE(std::filesystem::exists(options.folder));
    }
  }
  FAIL() << "it came to no end";
}

TEST_F(Csv, ARateOfNothingIsNoRate) {
  ImportOptions options = simple(folder_);
  options.files = {{folder_.write("a.csv", "t,f,a\n0,1,3\n1,2,4\n"), {}}};
  options.sample_rate_hz = 0.0;
  try {
    (void)import_recordings(options);
    FAIL();
  } catch (const InputError& error) {
    EXPECT_NE(std::string(error.what()).find("has a sampling rate of 0 Hz"),
              std::string::npos)
        << error.what();
  }
}

TEST_F(Csv, AnObjectIsNoListOfSignals) {
  const auto said = [&](const std::string& text) {
    try {
      (void)read_time_table(folder_.write("a.json", text), {"f"}, {});
    } catch (const InputError& error) {
      return std::string(error.what());
    }
    return std::string();
  };
  EXPECT_NE(said(R"({"F": 1})").find("is no list of signals"),
            std::string::npos);
  EXPECT_NE(said(R"([{"data": [1]}, {"data": [2]}])")
                .find("use a number from 1 to 2"),
            std::string::npos);
  EXPECT_NE(said(R"([{"data": [1]}, {"data": [2], "name": "b"}])")
                .find("use b, or a number from 1 to 2"),
            std::string::npos);
}

// Real files: PCD-400A, 50 Hz, one hit each with negative blows, the pulse one
// to three samples long and, in set 3, five samples after the file's start.
TEST_F(Csv, ReadsTheThreeStoreyFrame) {
  const std::filesystem::path data =
      TAPFIT_SOURCE_DIR "/../shared/data/three-storey-frame";
  if (!std::filesystem::exists(data)) {
    GTEST_SKIP() << data << " is not there";
  }
  ImportOptions options = simple(folder_);
  options.hammer.column = "CH8";
  options.hammer.volts_per_unit = 49.0;
  options.sensors.clear();
  int node = 1;
  for (const char* column : {"CH2", "CH3", "CH5", "CH6"}) {
    options.sensors.push_back({.column = column,
                               .channel = column,
                               .unit = "cm/s^2",
                               .dof = {node++, 1, 1}});
  }
  for (const char* name : {"imp_ham_set1_nomass.CSV",
                           "imp_ham_set2_nomass.CSV",
                           "imp_ham_set3_no_mass.CSV"}) {
    options.files.push_back({data / name, {}});
  }
  const TestBundle bundle = import_recordings(options);
  const std::vector<Recording> recordings = read_recordings(bundle);
  EXPECT_EQ(recordings[0].sample_rate_hz, 50.0);
  EXPECT_EQ(recordings[0].samples.rows(), 9028);
  EXPECT_NEAR(recordings[2].samples(5, 0), -137.621949512195 / 49.0, 1e-12);
  const HitSet hits = find_hits(bundle, recordings, {});
  for (const std::vector<Hit>& run : hits.runs) {
    ASSERT_EQ(run.size(), 1U);
    EXPECT_TRUE(run[0].accepted) << name(run[0].reasons.front());
  }
  EXPECT_EQ(hits.runs[2][0].trigger, 5);
}

}  // namespace
}  // namespace tapfit::acquisition
