#include "acquisition/bundle/recording.hpp"

#include "acquisition/bundle/run_reader.hpp"
#include "acquisition/foundation/input_error.hpp"
#include "acquisition/readers/audio_file.hpp"
#include "tests/acquisition/support/hammer_record.hpp"
#include "tests/acquisition/support/temporary_folder.hpp"
#include "tests/support/matchers.hpp"

#include <cmath>
#include <limits>

namespace tapfit::acquisition {
namespace {

Eigen::MatrixXd ramp(Eigen::Index rows, Eigen::Index columns) {
  Eigen::MatrixXd samples(rows, columns);
  for (Eigen::Index i = 0; i < samples.size(); ++i) {
    samples.data()[i] = std::sin(0.1 * static_cast<double>(i));
  }
  return samples;
}

std::string text_of(const std::filesystem::path& file) {
  std::ifstream stream(file, std::ios::binary);
  return {std::istreambuf_iterator<char>(stream), {}};
}

class Recordings : public ::testing::Test {
 protected:
  Recordings() {
    bundle_ = testing::hammer_bundle();
    bundle_.runs[0].file = folder_.path() / "run.wav";
  }
  std::string refusal() {
    return refusal_of([this] { (void)read_recordings(bundle_); });
  }
  testing::TemporaryFolder folder_;
  TestBundle bundle_;
};

TEST_F(Recordings, ComeBackFromEveryFormat) {
  const Eigen::MatrixXd samples = ramp(70000, 2);
  const double step24 = std::exp2(-23);  // one step of 24 bits
  for (const auto& [format, name, tolerance] :
       {std::tuple{AudioFormat::WavFloat64, "a.wav", 0.0},
        std::tuple{AudioFormat::Wav24, "b.wav", step24},
        std::tuple{AudioFormat::Flac24, "c.flac", step24}}) {
    write_audio(folder_.path() / name, samples, 4096, format);
    const Audio audio = read_audio(folder_.path() / name);
    EXPECT_EQ(audio.sample_rate_hz, 4096.0);
    ASSERT_EQ(audio.samples.rows(), samples.rows());
    EXPECT_LE((audio.samples - samples).cwiseAbs().maxCoeff(), tolerance)
        << name;
  }
}

TEST_F(Recordings, ClipBeyondFullScaleInsteadOfWrapping) {
  const Eigen::MatrixXd samples = 1.7 * ramp(1000, 1);
  write_audio(folder_.path() / "a.wav", samples, 100, AudioFormat::Wav24);
  const Audio audio = read_audio(folder_.path() / "a.wav");
  const Eigen::MatrixXd clipped = samples.cwiseMax(-1.0).cwiseMin(1.0);
  EXPECT_LE((audio.samples - clipped).cwiseAbs().maxCoeff(), std::exp2(-22));
}

TEST_F(Recordings, AreScaledToSi) {
  bundle_.channels[1].full_scale_volts = 5.0;
  bundle_.channels[1].sensitivity = 0.1;
  bundle_.channels[1].unit_to_si = 9.80665;
  const Eigen::MatrixXd samples = 0.5 * ramp(100, 2);
  write_audio(bundle_.runs[0].file, samples, 256, AudioFormat::WavFloat64);
  const Recording recording = read_recording(bundle_, bundle_.runs[0]);
  EXPECT_TRUE(recording.samples.col(0).isApprox(500.0 * samples.col(0)));
  EXPECT_TRUE(
      recording.samples.col(1).isApprox(5.0 / 0.1 * 9.80665 * samples.col(1)));
}

TEST_F(Recordings, RefuseWhatIsNotFinite) {
  Eigen::MatrixXd samples = ramp(200, 2);
  samples(128, 1) = std::numeric_limits<double>::quiet_NaN();
  write_audio(bundle_.runs[0].file, samples, 256, AudioFormat::WavFloat64);
  const std::string what = refusal();
  EXPECT_THAT(what, HasSubstr("acc1"));
  EXPECT_THAT(what, HasSubstr("0.500000 s"));
  EXPECT_THAT(what, HasSubstr("run.wav"));
}

TEST_F(Recordings, RefuseADeadChannel) {
  Eigen::MatrixXd samples = ramp(200, 2);
  samples.col(1).setConstant(0.25);
  write_audio(bundle_.runs[0].file, samples, 256, AudioFormat::WavFloat64);
  const std::string what = refusal();
  EXPECT_THAT(what, HasSubstr("\"acc1\" is dead"));
  EXPECT_THAT(what, HasSubstr("125 m/s^2"));
  // A channel that the run does not use may be dead.
  bundle_.runs[0].sensors.clear();
  EXPECT_EQ(refusal(), "");
}

TEST_F(Recordings, RefuseAWrongNumberOfChannels) {
  write_audio(bundle_.runs[0].file, ramp(9, 3), 256, AudioFormat::Wav24);
  EXPECT_THAT(refusal(), HasSubstr("3 channels"));
}

TEST_F(Recordings, RefuseABandBeyondHalfTheRate) {
  write_audio(bundle_.runs[0].file, ramp(9, 2), 256, AudioFormat::Wav24);
  bundle_.band_hz = {1.0, 128.0};
  EXPECT_THAT(refusal(), HasSubstr("band_hz"));
}

TEST_F(Recordings, RefuseDifferingRates) {
  bundle_.runs.push_back(bundle_.runs[0]);
  bundle_.runs[1].file = folder_.path() / "other.wav";
  write_audio(bundle_.runs[0].file, ramp(9, 2), 256, AudioFormat::Wav24);
  write_audio(bundle_.runs[1].file, ramp(9, 2), 512, AudioFormat::Wav24);
  EXPECT_THAT(refusal(), HasSubstr("512 Hz"));
}

TEST_F(Recordings, RefuseMissingEmptyAndForeignFiles) {
  EXPECT_THAT(refusal(), HasSubstr("no such file"));
  folder_.write("run.wav", "");
  EXPECT_THAT(refusal(), HasSubstr("sound file"));
  folder_.write("run.wav", "time,force\n0,1\n");
  EXPECT_THAT(refusal(), HasSubstr("sound file"));
  write_audio(
      bundle_.runs[0].file, Eigen::MatrixXd(0, 2), 256, AudioFormat::Wav24);
  EXPECT_THAT(refusal(), HasSubstr("no samples"));
}

// Cut at any length, a file is refused: never a shorter record in silence.
TEST_F(Recordings, RefuseCutFiles) {
  const Eigen::MatrixXd samples = 0.5 * ramp(20000, 2);
  for (const auto format :
       {AudioFormat::Wav24, AudioFormat::WavFloat64, AudioFormat::Flac24}) {
    write_audio(bundle_.runs[0].file, samples, 256, format);
    const std::string whole = text_of(bundle_.runs[0].file);
    for (const double part : {0.001, 0.01, 0.3, 0.7, 0.99}) {
      const auto size =
          static_cast<std::size_t>(part * static_cast<double>(whole.size()));
      folder_.write("run.wav", whole.substr(0, size));
      EXPECT_NE(refusal(), "")
          << "format " << static_cast<int>(format) << " part " << part;
    }
  }
}

}  // namespace
}  // namespace tapfit::acquisition
