#include "acquisition/bundle/uff_bundle.hpp"

#include "acquisition/bundle/read_test_bundle.hpp"
#include "acquisition/bundle/recording_stream.hpp"
#include "acquisition/bundle/run_reader.hpp"
#include "acquisition/foundation/input_error.hpp"
#include "tests/acquisition/support/temporary_folder.hpp"
#include "tests/acquisition/support/uff_text.hpp"
#include "tests/support/matchers.hpp"

#include <fmt/format.h>

#include <cmath>

namespace tapfit::acquisition {
namespace {

namespace fs = std::filesystem;
using testing::uff_ascii;
using testing::uff_binary;
using testing::UffTestRecord;

class UffBundle : public ::testing::Test {
 protected:
  testing::TemporaryFolder folder_;

  std::string refusal(const std::string& text) {
    return refusal_of(
        [&] { (void)read_test_bundle(folder_.write("bad.uff", text)); });
  }
};

UffTestRecord force(int node, std::vector<double> values) {
  return {.node = node, .axis = 13, .unit = "lbf", .values = std::move(values)};
}

TEST_F(UffBundle, TimeRecordsBecomeRuns) {
  // Roving hammer: two blows, two sensors, the second looking down.
  std::string text =
      uff_ascii(force(3, {0, 1, 0})) +
      uff_ascii({.node = 12, .values = {0, 5, -5}}) +
      uff_ascii({.node = 7, .direction = -1, .unit = "g", .values = {0, 1, 2}});
  // The second run as another program writes it: binary, CRLF throughout.
  for (UffTestRecord record :
       {force(9, {0, 0.5, 0, 0}),
        UffTestRecord{.node = 12, .values = {0, 1, 2, 3}},
        UffTestRecord{
            .node = 7, .direction = -1, .unit = "g", .values = {1, 1, 2, 3}}}) {
    record.eol = "\r\n";
    text += uff_binary(record);
  }
  const TestBundle bundle = read_test_bundle(folder_.write("test.uff", text));
  ASSERT_EQ(bundle.runs.size(), 2U);
  ASSERT_EQ(bundle.channels.size(), 3U);
  EXPECT_EQ(name(bundle.runs[0].hammer.dof), "3Z+");
  EXPECT_EQ(name(bundle.runs[1].hammer.dof), "9Z+");
  EXPECT_EQ(name(bundle.runs[1].sensors.at(1).dof), "7X-");
  EXPECT_TRUE(bundle.warnings.empty());

  const std::vector<Recording> recordings = read_recordings(bundle);
  EXPECT_EQ(recordings[0].sample_rate_hz, 1024.0);
  // 1 lbf and 1 g by definition.
  EXPECT_DOUBLE_EQ(recordings[0].samples(1, 0), 4.4482216152605);
  EXPECT_DOUBLE_EQ(recordings[0].samples(2, 1), -5.0);
  EXPECT_DOUBLE_EQ(recordings[0].samples(2, 2), 2.0 * 9.80665);
  EXPECT_DOUBLE_EQ(recordings[1].samples(1, 0), 0.5 * 4.4482216152605);
  EXPECT_DOUBLE_EQ(recordings[1].samples(3, 2), 3.0 * 9.80665);
}

TEST_F(UffBundle, LocalSystemsAreHonoured) {
  const std::string systems =
      "    -1\n    18\n"
      "         5         0         0         8         1\nCS\n"
      "  0.00000E+00  0.00000E+00  0.00000E+00  8.66025E-01  0.00000E+00 "
      "-5.00000E-01\n  5.00000E-01  0.00000E+00  8.66025E-01\n    -1\n";
  const std::string nodes =
      "    -1\n    15\n"
      "        12         0         5         8  1.00000E+00  0.00000E+00  "
      "0.00000E+00\n    -1\n";
  const std::string text =
      uff_ascii(force(3, {0, 1, 0})) +
      uff_ascii({.node = 12, .values = {0, 5, -5}}) +
      uff_ascii({.node = 12, .direction = -1, .values = {0, 1, 2}});
  const TestBundle bundle =
      read_test_bundle(folder_.write("test.uff", text + nodes + systems));
  ASSERT_EQ(bundle.runs.size(), 1U);
  EXPECT_EQ(name(bundle.runs[0].hammer.dof), "3Z+");
  EXPECT_EQ(name(bundle.runs[0].sensors.at(0).dof), "P12Z+");
  EXPECT_EQ(name(bundle.runs[0].sensors.at(1).dof), "P12X-");
  ASSERT_EQ(bundle.points.size(), 1U);
  EXPECT_EQ(bundle.points[0].node, 12);
  EXPECT_TRUE(bundle.points[0].axes.col(2).isApprox(
      Eigen::Vector3d(0.5, 0.0, std::sqrt(0.75)), 1e-5));
  EXPECT_THAT(refusal(text + nodes),
              HasSubstr("coordinate system 5 is not in the file"));
}

TEST_F(UffBundle, UnlabelledValuesAreInTheUnitsOf164) {
  const std::string units =
      "    -1\n   164\n         5mm N s\n"
      "  1.00000000000000000D+03  1.00000000000000000D+00"
      "  1.00000000000000000D+00\n    -1\n";
  const TestBundle bundle = read_test_bundle(folder_.write(
      "mm.uff",
      units + uff_ascii({.node = 3, .axis = 13, .unit = "", .values = {0, 2}}) +
          uff_ascii({.node = 1, .unit = "NONE", .values = {0, 500}})));
  const Recording recording = read_recording(bundle, bundle.runs.at(0));
  EXPECT_DOUBLE_EQ(recording.samples(1, 0), 2.0);
  EXPECT_DOUBLE_EQ(recording.samples(1, 1), 0.5);
}

// A record in what nobody knows is no record in SI.
// Cut off between its reading as a bundle and as recordings.
TEST_F(UffBundle, DatasetsThatAreGoneAreRefused) {
  const std::string first = uff_ascii(force(3, {0, 1, 0}));
  const TestBundle bundle = read_test_bundle(folder_.write(
      "test.uff", first + uff_ascii({.node = 12, .values = {0, 5, -5}})));
  ASSERT_EQ(bundle.runs.size(), 1U);
  folder_.write("test.uff", first);
  EXPECT_THROW((void)read_recording(bundle, bundle.runs[0]), InputError);
  const UffFile file = open_uff(*bundle.uff);
  EXPECT_THROW(RecordingStream(bundle, bundle.runs[0], &file), InputError);
}

TEST_F(UffBundle, UnknownLabelsAreLeftOutByName) {
  for (const char* label : {"mV", "V", "g rms", "m/s^2/V", "furlong", "N"}) {
    const TestBundle bundle = read_test_bundle(folder_.write(
        "label.uff",
        uff_ascii(force(3, {0, 1})) +
            uff_ascii({.node = 1, .unit = label, .values = {0, 1}}) +
            uff_ascii({.node = 2, .unit = "G", .values = {0, 1}})));
    ASSERT_EQ(bundle.runs.size(), 1U) << label;
    EXPECT_EQ(bundle.runs[0].sensors.size(), 1U) << label;
    EXPECT_EQ(read_recordings(bundle)[0].samples(1, 1), 9.80665) << label;
    ASSERT_EQ(bundle.warnings.size(), 1U) << label;
    for (const std::string& part :
         {std::string("label.uff, line "),
          fmt::format("\"{}\" is no known unit of acceleration", label),
          std::string("mm/s^2")}) {
      EXPECT_THAT(bundle.warnings[0], HasSubstr(part));
    }
  }
}

TEST_F(UffBundle, RefusesAForceInAnUnknownUnit) {
  UffTestRecord hammer = force(3, {0, 1});
  hammer.unit = "mV";
  const std::string said =
      refusal(uff_ascii(hammer) + uff_ascii({.node = 1, .values = {0, 1}}));
  EXPECT_THAT(said,
              HasSubstr("\"mV\" is no known unit of force; known are N,"));
}

// Else a moved sensor's record would count as an answer to the blow before.
TEST_F(UffBundle, MotionsOfALostForceAreNotTheRunsBefore) {
  UffTestRecord lost = force(3, {0, 1});
  lost.unit = "mV";
  const TestBundle bundle = read_test_bundle(folder_.write(
      "lost.uff",
      uff_ascii(force(3, {0, 1})) + uff_ascii({.node = 1, .values = {0, 1}}) +
          uff_ascii(lost) + uff_ascii({.node = 2, .values = {0, 1}}) +
          uff_ascii(force(3, {0, 1})) +
          uff_ascii({.node = 5, .values = {0, 1}})));
  ASSERT_EQ(bundle.runs.size(), 2U);
  ASSERT_EQ(bundle.runs[0].sensors.size(), 1U);
  EXPECT_EQ(bundle.runs[0].sensors[0].dof.node, 1);
  EXPECT_EQ(bundle.runs[1].sensors.at(0).dof.node, 5);
  EXPECT_EQ(bundle.warnings.size(), 2U);
}

TEST_F(UffBundle, SaysWhatItLeavesOut) {
  const TestBundle bundle = read_test_bundle(folder_.write(
      "odd.uff",
      uff_ascii(force(3, {0, 1})) + uff_ascii({.node = 1, .values = {0, 1}}) +
          uff_ascii({.direction = 0, .values = {1, 2}}) +
          uff_ascii({.axis = 15, .unit = "Pa", .values = {1, 2}}) +
          uff_ascii(force(4, {0, 1}))));
  EXPECT_EQ(bundle.runs.size(), 1U);
  ASSERT_EQ(bundle.warnings.size(), 3U);
  EXPECT_THAT(bundle.warnings[0], HasSubstr("no direction"));
  EXPECT_THAT(bundle.warnings[1], HasSubstr("Pa"));
  EXPECT_THAT(bundle.warnings[2], HasSubstr("one force"));
}

TEST_F(UffBundle, FrfsAreABundleToo) {
  const fs::path file =
      folder_.write("h.uff", uff_ascii({.function_type = 4, .values = {1, 2}}));
  EXPECT_EQ(read_test_bundle(file).frfs, file);
}

TEST_F(UffBundle, RefusesWithAPlace) {
  EXPECT_THAT(refusal(uff_ascii({.values = {1, 2}})), HasSubstr("neither"));
  std::string cut = uff_ascii(force(3, {0, 1, 2, 3, 4}));
  cut.resize(cut.size() - 30);
  const fs::path file = folder_.write(
      "cut.uff", uff_ascii({.node = 1, .values = {0, 1, 2, 3, 4}}) + cut);
  const TestBundle bundle = read_test_bundle(file);
  EXPECT_THAT([&] { (void)read_recordings(bundle); }, Refuses("cut.uff, line"));
}

// Files of other programs: none holds a hammer, and all say why they are
// refused instead of being taken for something.
TEST_F(UffBundle, OthersFilesAreRefusedWithAReason) {
  const fs::path samples = TAPFIT_SOURCE_DIR "/../shared/data/uff-samples";
  if (!fs::is_directory(samples)) GTEST_SKIP() << samples << " is not there";
  for (const auto& entry : fs::directory_iterator(samples)) {
    if (entry.path().extension() != ".uff") continue;
    ASSERT_TRUE(is_uff(entry.path())) << entry;
    // One has an FRF without points: a bundle of FRFs until they are asked for.
    if (entry.path().filename() == "non_ascii_header.uff") continue;
    EXPECT_THROW((void)read_test_bundle(entry.path()), InputError) << entry;
  }
}

// A file of modes is told what makes a test of it.
TEST_F(UffBundle, ModesAloneBelongToATest) {
  const std::string text = refusal("    -1\n    55\nmodes\n    -1\n");
  EXPECT_NE(text.find("holds results at nodes, such as modes"),
            std::string::npos)
      << text;
  EXPECT_NE(text.find(R"({"tapfit": 1, "modes": "bad.uff"} as test.json)"),
            std::string::npos)
      << text;
}

}  // namespace
}  // namespace tapfit::acquisition
