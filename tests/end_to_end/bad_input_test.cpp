// Bad input and bad command lines: the exit status tells whose fault it is,
// the message names the place, and nothing reaches standard output.
#include "tests/end_to_end/run_program.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <array>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <limits>
#include <numbers>
#include <vector>

namespace tapfit::end_to_end {
namespace {

namespace fs = std::filesystem;
using nlohmann::json;

template <typename T>
void append(std::string& bytes, T value) {
  std::array<char, sizeof(T)> raw{};
  std::memcpy(raw.data(), &value, sizeof(T));
  bytes.append(raw.data(), raw.size());
}

/// A 32-bit float WAV file; samples are interleaved.
std::string float_wav(std::uint16_t channels,
                      std::uint32_t rate,
                      const std::vector<float>& samples) {
  const auto data_bytes = static_cast<std::uint32_t>(4 * samples.size());
  std::string bytes = "RIFF";
  append(bytes, std::uint32_t{36 + data_bytes});
  bytes += "WAVEfmt ";
  append(bytes, std::uint32_t{16});
  append(bytes, std::uint16_t{3});  // IEEE float
  append(bytes, channels);
  append(bytes, rate);
  append(bytes, std::uint32_t{rate * channels * 4});
  append(bytes, static_cast<std::uint16_t>(channels * 4));
  append(bytes, std::uint16_t{32});
  bytes += "data";
  append(bytes, data_bytes);
  for (const float sample : samples) append(bytes, sample);
  return bytes;
}

json sample_test_json() {
  return json::parse(R"json({
    "tapfit": 1, "title": "sample", "band_hz": [5, 100],
    "channels": [
      {"name": "hammer", "quantity": "force", "unit": "N",
       "sensitivity": 0.01, "sensitivity_unit": "V/N",
       "full_scale_volts": 5.0},
      {"name": "acc1", "quantity": "acceleration", "unit": "m/s^2",
       "sensitivity": 0.01, "sensitivity_unit": "V/(m/s^2)",
       "full_scale_volts": 5.0}],
    "runs": [{"file": "run-01.wav",
      "hammer": {"channel": "hammer", "node": 1, "direction": "+Z"},
      "sensors": [{"channel": "acc1", "node": 2, "direction": "+Z"}]}]
  })json");
}

/// A 25 Hz oscillator that is tapped once: force, acceleration.
std::vector<float> sample_tap() {
  std::vector<float> samples;
  for (int k = 0; k < 4096; ++k) {
    const double t = (k - 200) / 1024.0;
    // A half sine of 12 samples, well below the Nyquist frequency.
    const double pulse =
        k >= 200 && k < 212
            ? 0.4 * std::sin(std::numbers::pi * (k - 200) / 12.0)
            : 0.0;
    samples.push_back(static_cast<float>(pulse));
    samples.push_back(static_cast<float>(
        t > 0.0 ? 0.2 * std::exp(-3.0 * t) * std::sin(157.08 * t) : 0.0));
  }
  return samples;
}

class BadInput : public testing::Test {
 protected:
  void SetUp() override {
    bundle_ = fresh_folder() / "bundle";
    write_json(sample_test_json());
    write_file(bundle_ / "run-01.wav", float_wav(2, 1024, sample_tap()));
  }
  void write_json(const json& test) {
    write_file(bundle_ / "test.json", test.dump());
  }
  ProgramResult run(const std::string& command) {
    return run_tapfit(fmt::format("{} '{}'", command, bundle_.string()));
  }
  /// Status 1, the words in the message, and a silent standard output.
  void expect_input_fault(const ProgramResult& result,
                          const std::vector<std::string>& words) {
    EXPECT_EQ(result.exit_status, 1);
    EXPECT_EQ(result.out, "");
    for (const std::string& word : words) {
      EXPECT_NE(result.err.find(word), std::string::npos)
          << '"' << word << "\" is not in: " << result.err;
    }
  }

  fs::path bundle_;
};

TEST_F(BadInput, HealthySampleGivesItsHitAsJson) {
  const ProgramResult result = run("hits --json");
  ASSERT_EQ(result.exit_status, 0) << result.err;
  const json hits = json::parse(result.out).at("runs").at(0).at("hits");
  ASSERT_EQ(hits.size(), 1U);
  // 0.4 of full scale, 5 V / (0.01 V/N) = 500 N: 200 N at 206/1024 s. The
  // peak between samples may be a percent above the highest sample.
  EXPECT_NEAR(hits.at(0).at("peak_n").get<double>(), 200.0, 4.0);
  EXPECT_NEAR(hits.at(0).at("time_s").get<double>(), 206.0 / 1024.0, 0.001);
  EXPECT_TRUE(hits.at(0).at("accepted").is_boolean());
}

// Every FRF has the wrong sign then.
TEST_F(BadInput, NegativeBlowsAreToldOfWhereverFrfsAreSeen) {
  auto samples = sample_tap();
  for (std::size_t k = 0; k < samples.size(); k += 2) samples[k] *= -1.0F;
  write_file(bundle_ / "run-01.wav", float_wav(2, 1024, samples));
  for (const char* command :
       {"hits", "frf", "frf --estimator H2", "modes", "modes --json", "run"}) {
    const ProgramResult result = run(command);
    ASSERT_EQ(result.exit_status, 0) << command << result.err;
    EXPECT_NE(result.out.find("blows are negative"), std::string::npos)
        << command;
  }
}

TEST_F(BadInput, TheBlockIsNamedWhereItSpoilsAllHits) {
  json test = sample_test_json();
  test["block_s"] = 2.5;
  write_json(test);
  auto samples = sample_tap();  // once more, 1.5 s later
  for (std::size_t k = samples.size(); k-- > 2 * 1536;) {
    samples[k] += samples[k - 2 * 1536];
  }
  write_file(bundle_ / "run-01.wav", float_wav(2, 1024, samples));
  expect_input_fault(run("frf"),
                     {"no run has an accepted hit", "block_s of 2.5"});
}

TEST_F(BadInput, NothingIsErasedWhereThereIsNoTerminal) {
  const ProgramResult result = run("replay");
  ASSERT_EQ(result.exit_status, 0) << result.err;
  EXPECT_EQ(result.err.find_first_of("\r\x1b"), std::string::npos);
  EXPECT_NE(result.err.find("average of 1"), std::string::npos);
}

TEST_F(BadInput, AFileOfFrfsIsNoTestJson) {
  const fs::path file = bundle_ / "frfs.uff";
  ASSERT_EQ(run(fmt::format("frf --uff '{}'", file.string())).exit_status, 0);
  const ProgramResult result =
      run_tapfit(fmt::format("hits '{}'", file.string()));
  expect_input_fault(result, {"frfs.uff", "time records"});
  EXPECT_EQ(result.err.find("test.json"), std::string::npos) << result.err;
}

TEST_F(BadInput, MissingFolderIsNamed) {
  fs::remove_all(bundle_);
  expect_input_fault(run("run"), {bundle_.string()});
}

TEST_F(BadInput, BrokenJsonIsNamed) {
  write_file(bundle_ / "test.json", "{\"tapfit\": 1,");
  expect_input_fault(run("run --json"), {"test.json"});
}

TEST_F(BadInput, MissingRecordingIsNamed) {
  fs::remove(bundle_ / "run-01.wav");
  expect_input_fault(run("hits"), {"run-01.wav"});
}

TEST_F(BadInput, FileThatIsNoSoundIsNamed) {
  write_file(bundle_ / "run-01.wav", "this is no sound");
  expect_input_fault(run("hits"), {"run-01.wav"});
}

TEST_F(BadInput, WrongChannelCountIsNamed) {
  write_file(bundle_ / "run-01.wav", float_wav(1, 1024, sample_tap()));
  expect_input_fault(run("hits"), {"run-01.wav", "channel"});
}

TEST_F(BadInput, NaNSampleIsNamedWithItsChannel) {
  auto samples = sample_tap();
  samples[2 * 512 + 1] = std::numeric_limits<float>::quiet_NaN();
  write_file(bundle_ / "run-01.wav", float_wav(2, 1024, samples));
  expect_input_fault(run("hits"), {"run-01.wav", "acc1"});
}

TEST_F(BadInput, UnknownChannelIsNamed) {
  json test = sample_test_json();
  test["runs"][0]["sensors"][0]["channel"] = "acc9";
  write_json(test);
  expect_input_fault(run("hits"), {"acc9"});
}

TEST_F(BadInput, UnknownGridIsNamed) {
  json test = sample_test_json();
  test["model"] = "model.bdf";
  test["runs"][0]["sensors"][0]["node"] = 77;
  write_json(test);
  write_file(bundle_ / "model.bdf",
             "BEGIN BULK\n"
             "GRID,1,,0.,0.,0.\nGRID,2,,1.,0.,0.\n"
             "CBAR,1,1,1,2,0.,0.,1.\n"
             "PBAR,1,1,1.-4,1.-8,1.-8,2.-8\n"
             "MAT1,1,7.+10,,.33,2700.\n"
             "SPC1,1,123456,1\nENDDATA\n");
  expect_input_fault(run("compare"), {"77"});
}

TEST_F(BadInput, CompareWithoutAModelSaysSo) {
  expect_input_fault(run("compare"), {"model"});
}

TEST_F(BadInput, DeckWithAMissingPropertyIsNamed) {
  write_file(bundle_ / "bad.bdf",
             "BEGIN BULK\nGRID,1,,0.,0.,0.\nGRID,2,,1.,0.,0.\n"
             "CBAR,1,99,1,2,0.,0.,1.\nENDDATA\n");
  const ProgramResult result =
      run_tapfit(fmt::format("model '{}/bad.bdf'", bundle_.string()));
  expect_input_fault(result, {"bad.bdf", "99"});
}

// An area that no structure has ends with the card that holds it.
TEST_F(BadInput, DeckWithAnAreaBeyondAllReasonIsRefused) {
  const fs::path deck = bundle_ / "large.bdf";
  std::string cards =
      read_file(TAPFIT_SOURCE_DIR "/recordings/paper-solar-wing/model.bdf");
  const std::size_t card = cards.find("PBAR,2,1,4.-4");
  ASSERT_NE(card, std::string::npos);
  cards.replace(card, 13, "PBAR,2,1,1.+38");
  write_file(deck, cards);
  expect_input_fault(run_tapfit(fmt::format("model '{}'", deck.string())),
                     {"PBAR 2", "A is 1e+38"});
}

TEST_F(BadInput, UnknownEffectIsNamed) {
  const auto result = run("update --effect wishful-thinking@1");
  // The command line is at fault, not the bundle.
  EXPECT_EQ(result.exit_status, 2);
  EXPECT_EQ(result.out, "");
  EXPECT_NE(result.err.find("wishful-thinking"), std::string::npos);
}

TEST(BadCommandLine, IsStatusTwoWithASilentOutput) {
  for (const char* arguments : {"",
                                "run",
                                "hits --no-such-option x",
                                "run x y",
                                "model x --modes -1"}) {
    const ProgramResult result = run_tapfit(arguments);
    EXPECT_EQ(result.exit_status, 2) << arguments;
    EXPECT_EQ(result.out, "") << arguments;
    EXPECT_NE(result.err, "") << arguments;
  }
}

TEST(BadCommandLine, TerminalIsNotOpenedWithoutOne) {
  const ProgramResult result =
      run_tapfit("'" TAPFIT_SOURCE_DIR "/recordings/paper-truss'");
  EXPECT_EQ(result.exit_status, 2);
  EXPECT_EQ(result.out, "");
  EXPECT_NE(result.err.find("tapfit run"), std::string::npos) << result.err;
}

TEST(BadCommandLine, AFolderThatIsNotThereIsNamed) {
  const ProgramResult result = run_tapfit("w33/nowhere");
  EXPECT_EQ(result.exit_status, 1);
  EXPECT_EQ(result.out, "");
  EXPECT_NE(result.err.find("w33/nowhere: is not there"), std::string::npos)
      << result.err;
}

TEST_F(BadInput, ATableThatIsNoneIsTheCommandLinesFault) {
  const ProgramResult result = run("hits --csv=foo");
  EXPECT_EQ(result.exit_status, 2);
  EXPECT_NE(result.err.find("there is no table \"foo\""), std::string::npos)
      << result.err;
}

TEST(HelpAndVersion, AreOnStandardOutput) {
  const ProgramResult help = run_tapfit("--help");
  EXPECT_EQ(help.exit_status, 0);
  EXPECT_EQ(help.err, "");
  EXPECT_NE(help.out.find("diagnose"), std::string::npos) << help.out;
  const ProgramResult version = run_tapfit("--version");
  EXPECT_EQ(version.exit_status, 0);
  EXPECT_TRUE(version.out.starts_with("tapfit ")) << version.out;
}

TEST(BadFile, AUniversalFileWithoutDatasetsIsNone) {
  const auto result = run_tapfit("uff '" TAPFIT_SOURCE_DIR "/README.md'");
  EXPECT_NE(result.exit_status, 0);
  EXPECT_NE(result.err.find("no dataset"), std::string::npos) << result.err;
}

}  // namespace
}  // namespace tapfit::end_to_end
