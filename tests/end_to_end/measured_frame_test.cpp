// A real hammer test, measured by others: a three-storey steel frame, recorded
// as CSV. Their folder lies beside the project and is not part of it.
#include "tests/end_to_end/run_program.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <array>
#include <cmath>

namespace tapfit::end_to_end {
namespace {

namespace fs = std::filesystem;
using nlohmann::json;

const fs::path data = TAPFIT_SOURCE_DIR "/../shared/data/three-storey-frame";

fs::path imported(const std::string& file, const std::string& how) {
  const fs::path bundle = fresh_folder() / "frame";
  fs::remove_all(bundle);
  const auto result = run_tapfit(fmt::format(
      "import '{}' -o '{}' {}", (data / file).string(), bundle.string(), how));
  EXPECT_EQ(result.exit_status, 0) << result.err;
  return bundle;
}

json json_of(const std::string& arguments) {
  const auto result = run_tapfit(arguments);
  EXPECT_EQ(result.exit_status, 0) << result.err;
  return result.exit_status == 0 ? json::parse(result.out) : json();
}

struct Record {
  const char* file;
  double hz[3];  // as the data's note says
  std::size_t poles = 3;
};

class MeasuredFrame : public testing::TestWithParam<Record> {};

TEST_P(MeasuredFrame, ItsResonancesComeOutOfTheImportedRecord) {
  if (!fs::exists(data)) GTEST_SKIP() << data << " is not there";
  const fs::path bundle = imported(
      GetParam().file,
      "--hammer CH8@3:+X,volts_per_unit=1 --sensor CH2@1:+X,unit=cm/s^2 "
      "--sensor CH3@2:-X,unit=cm/s^2 --sensor CH5@3:+X,unit=cm/s^2 "
      "--band 1 20");
  const json modes =
      json_of(fmt::format("modes '{}' --json", bundle.string())).at("modes");
  ASSERT_EQ(modes.size(), GetParam().poles);
  // 0.5 % is what two ways of reading a peak differ by on a frame whose
  // frequencies move with the amplitude.
  for (const double hz : GetParam().hz) {
    double nearest = 1e300;
    for (const json& mode : modes) {
      const double f = mode.at("frequency_hz").at("value");
      nearest = std::min(nearest, std::abs(f - hz));
    }
    EXPECT_LT(nearest, 0.005 * hz) << hz;
  }
  // The same blows, streamed.
  const json replayed =
      json_of(fmt::format("replay '{}' --json", bundle.string()));
  EXPECT_EQ(replayed.at("runs").at(0).at("hits").size(), 1U);
  EXPECT_EQ(replayed.at("frf").at("frfs").size(), 3U);
}

INSTANTIATE_TEST_SUITE_P(
    Records,
    MeasuredFrame,
    testing::Values(Record{"imp_ham_set1_nomass.CSV", {2.171, 6.895, 13.237}},
                    Record{"imp_ham_set2_nomass.CSV", {2.166, 6.886, 13.235}},
                    // A weak hit; of this one the makers' values are known. The
                    // fourth pole is at 12.98 Hz.
                    Record{
                        "imp_ham_set3_no_mass.CSV", {2.17, 6.89, 13.263}, 4}));

// The weak hit's fourth pole is no third mode that moves: in another record,
// hit seven times as hard, a pole put in there comes to rest at the same
// frequency and with much the same shape, which is not the third mode's.
TEST(MeasuredFrameModes, ItsFourthPoleIsInAnotherRecordToo) {
  if (!fs::exists(data)) GTEST_SKIP() << data << " is not there";
  const std::string how =
      "--hammer CH8@3:+X,volts_per_unit=1 --sensor CH2@1:+X,unit=cm/s^2 "
      "--sensor CH3@2:-X,unit=cm/s^2 --sensor CH5@3:+X,unit=cm/s^2 "
      "--band 1 20";
  struct Seen {
    double hz = 0.0;
    std::array<double, 3> shape{};
  };
  const auto fourth = [&](const std::string& file, const std::string& more) {
    const fs::path bundle = imported(file, how);
    const json modes =
        json_of(fmt::format("modes '{}' {} --json", bundle.string(), more))
            .at("modes");
    EXPECT_EQ(modes.size(), 4U);
    Seen seen;
    for (const json& mode : modes) {
      const double hz = mode.at("frequency_hz").at("value");
      if (std::abs(hz - 12.98) > 0.1) continue;
      seen.hz = hz;
      std::size_t k = 0;
      for (const auto& [dof, value] : mode.at("shape").items()) {
        seen.shape.at(k++) = value.at(0);
      }
    }
    return seen;
  };
  const Seen weak = fourth("imp_ham_set3_no_mass.CSV", "");
  const Seen strong = fourth("imp_ham_set1_nomass.CSV", "--add 12.9");
  // Within three standard deviations, 0.004 and 0.006 Hz.
  EXPECT_NEAR(strong.hz, weak.hz, 0.02);
  const auto likeness = [](const auto& a, const auto& b) {
    double aa = 0.0;
    double bb = 0.0;
    double ab = 0.0;
    for (std::size_t k = 0; k < 3; ++k) {
      aa += a.at(k) * a.at(k);
      bb += b.at(k) * b.at(k);
      ab += a.at(k) * b.at(k);
    }
    return ab * ab / (aa * bb);
  };
  EXPECT_GT(likeness(weak.shape, strong.shape), 0.85);
  const std::array<double, 3> third{-0.009, 0.011, -0.006};
  EXPECT_LT(likeness(weak.shape, third), 0.5);
}

// As the note says: the second floor's sensor is turned; with its sign the
// other way the shapes are +++, ++-, +-+ (first floor to top). The base moves
// by some per cent of the top at most.
TEST(MeasuredFrameModes, TheirSignsShowTheTurnedSensor) {
  if (!fs::exists(data)) GTEST_SKIP() << data << " is not there";
  for (const char* file : {"imp_ham_set1_nomass.CSV",
                           "imp_ham_set2_nomass.CSV",
                           "imp_ham_set3_no_mass.CSV"}) {
    const fs::path bundle = imported(
        file,
        "--hammer CH8@3:+X,volts_per_unit=1 --sensor CH2@1:+X,unit=cm/s^2 "
        "--sensor CH3@2:+X,unit=cm/s^2 --sensor CH5@3:+X,unit=cm/s^2 "
        "--sensor CH6@4:+X,unit=cm/s^2 --band 1 20");
    const json modes =
        json_of(fmt::format("modes '{}' --json", bundle.string())).at("modes");
    struct Noted {
      double hz;
      std::array<int, 3> signs;  // relative to the first floor's
    };
    for (const Noted& noted : {Noted{2.17, {1, 1, 1}},
                               Noted{6.89, {1, 1, -1}},
                               Noted{13.24, {1, -1, 1}}}) {
      int seen = 0;
      for (const json& mode : modes) {
        const double hz = mode.at("frequency_hz").at("value");
        if (std::abs(hz - noted.hz) > 0.01 * noted.hz) continue;
        ++seen;
        const auto at = [&](const char* dof) -> double {
          return mode.at("shape").at(dof).at(0);
        };
        const double first = at("1X+");
        const int second = -at("2X+") * first > 0.0 ? 1 : -1;
        const int top = at("3X+") * first > 0.0 ? 1 : -1;
        EXPECT_EQ(second, noted.signs[1]) << file << " " << hz;
        EXPECT_EQ(top, noted.signs[2]) << file << " " << hz;
        EXPECT_LT(std::abs(at("4X+")), 0.05 * std::abs(at("3X+")));
      }
      EXPECT_EQ(seen, 1) << file << " " << noted.hz;
    }
  }
}

// Pulses of one to three samples without a filter: the program says that scale
// means nothing.
TEST(MeasuredFrameHits, SayThatTheScaleMeansNothing) {
  if (!fs::exists(data)) GTEST_SKIP() << data << " is not there";
  for (const char* file : {"imp_ham_set1_nomass.CSV",
                           "imp_ham_set2_nomass.CSV",
                           "imp_ham_set3_no_mass.CSV"}) {
    const fs::path bundle = imported(
        file,
        "--hammer CH8@3:+X,volts_per_unit=1 --sensor CH5@3:+X,unit=cm/s^2 "
        "--band 1 20");
    const auto result = run_tapfit(fmt::format("hits '{}'", bundle.string()));
    EXPECT_NE(result.out.find("show no anti-alias filter"), std::string::npos)
        << file << result.out;
  }
}

// The hammer's sensitivity in the file is 49 V/N of a mass of 2.5 kg: taken
// with both, the body answers as that mass. Pulses of one or two samples leave
// the gain to some per cent and say nothing of more.
TEST(MeasuredHammer, ItsCalibrationMassComesOut) {
  if (!fs::exists(data)) GTEST_SKIP() << data << " is not there";
  const fs::path bundle =
      imported("Imp_ham_calib_set1.CSV",
               "--hammer CH8@1:+X,volts_per_unit=49 "
               "--sensor CH6@1:+X,unit=cm/s^2 --rate 50 --band 2 20");
  const json found =
      json_of(fmt::format("calibrate '{}' --mass 2.5 --json", bundle.string()))
          .at("calibration");
  ASSERT_EQ(found.size(), 1U);
  EXPECT_NEAR(found[0].at("gain").at("value").get<double>(), 1.0, 0.1);
}

// The second record has one blow, and another gain (0.65): nothing to enter.
TEST(MeasuredHammer, TheSecondCalibrationIsNoMassAndGivesNoSensitivity) {
  if (!fs::exists(data)) GTEST_SKIP() << data << " is not there";
  const fs::path bundle = imported("imp_ham_calib_set2.CSV",
                                   "--hammer CH8@1:+X,volts_per_unit=49 "
                                   "--sensor CH6@1:+X,unit=cm/s^2 --band 2 20");
  const json found =
      json_of(fmt::format("calibrate '{}' --mass 2.5 --json", bundle.string()))
          .at("findings");
  ASSERT_EQ(found.size(), 1U);
  EXPECT_NE(found[0].at("what").get<std::string>().find("as a mass alone only"),
            std::string::npos);
}

}  // namespace
}  // namespace tapfit::end_to_end
