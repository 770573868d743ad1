// Every container and width of number that a recorder may write, from files
// made byte by byte: samples come back as they are, to the last bit.
#include "acquisition/bundle/lossy_files.hpp"
#include "acquisition/foundation/input_error.hpp"
#include "acquisition/readers/audio_file.hpp"
#include "acquisition/readers/sample_bytes.hpp"
#include "tests/acquisition/support/sound_text.hpp"
#include "tests/acquisition/support/temporary_folder.hpp"
#include "tests/support/matchers.hpp"

#include <sndfile.h>

#include <algorithm>

namespace tapfit::acquisition {
namespace {

using testing::SoundNumber;

// Full scale below zero, one step, and values in between, at the given bits.
Eigen::MatrixXd steps(int bits) {
  Eigen::MatrixXd x(600, 3);
  const double step = std::ldexp(1.0, 1 - bits);
  std::int64_t state = 12345;
  for (double& value : x.reshaped()) {
    state = (state * 48271) % 2147483647;
    value =
        std::floor((static_cast<double>(state) / 1073741824.0 - 1.0) / step) *
        step;
  }
  x(0, 0) = -1.0;
  x(1, 1) = step;
  x(2, 2) = 1.0 - step;
  return x;
}

class SoundContainers : public ::testing::Test {
 protected:
  void expect_back(const std::string& name,
                   const std::string& bytes,
                   const Eigen::MatrixXd& x,
                   bool floating) {
    const auto file = folder_.write(name, bytes);
    const Audio audio = read_audio(file);
    EXPECT_EQ(audio.sample_rate_hz, 51200.0) << name;
    ASSERT_EQ(audio.samples.rows(), x.rows()) << name;
    ASSERT_EQ(audio.samples.cols(), x.cols()) << name;
    EXPECT_EQ(audio.samples, x) << name;
    EXPECT_EQ(AudioReader(file).floating_point(), floating) << name;
  }
  testing::TemporaryFolder folder_;
};

TEST_F(SoundContainers, WholeNumbersOfEveryWidth) {
  for (const int bits : {16, 24, 32}) {
    const Eigen::MatrixXd x = steps(bits);
    const SoundNumber as{bits, false, false};
    const SoundNumber big{bits, false, true};
    const std::string tag = "-" + std::to_string(bits);
    expect_back("wav" + tag, wav_bytes(x, as, 51200), x, false);
    expect_back("wavex" + tag, wavex_bytes(x, as, 51200), x, false);
    expect_back("rf64" + tag, rf64_bytes(x, as, 51200), x, false);
    expect_back("w64" + tag, w64_bytes(x, as, 51200), x, false);
    expect_back("aiff" + tag, aiff_bytes(x, as, 51200), x, false);
    expect_back("caf" + tag, caf_bytes(x, as, 51200), x, false);
    expect_back("caf-big" + tag, caf_bytes(x, big, 51200), x, false);
  }
}

TEST_F(SoundContainers, FloatingPointOfBothWidths) {
  for (const int bits : {32, 64}) {
    // Beyond full scale, too: floating point does not clip.
    const Eigen::MatrixXd x = 3.0 * steps(16);
    const SoundNumber as{bits, true, false};
    const SoundNumber big{bits, true, true};
    const std::string tag = "-f" + std::to_string(bits);
    expect_back("wav" + tag, wav_bytes(x, as, 51200), x, true);
    expect_back("wavex" + tag, wavex_bytes(x, as, 51200), x, true);
    expect_back("rf64" + tag, rf64_bytes(x, as, 51200), x, true);
    expect_back("w64" + tag, w64_bytes(x, as, 51200), x, true);
    expect_back("aifc" + tag, aiff_bytes(x, as, 51200), x, true);
    expect_back("caf" + tag, caf_bytes(x, as, 51200), x, true);
    expect_back("caf-big" + tag, caf_bytes(x, big, 51200), x, true);
  }
}

// As a WAV says it: 600 x 3 numbers of 2 bytes are announced, the last 700
// bytes are gone.
TEST_F(SoundContainers, CutFilesAreRefused) {
  const Eigen::MatrixXd x = steps(16);
  const SoundNumber as{16, false, false};
  for (const auto& [name, bytes] :
       {std::pair{"wav", wav_bytes(x, as, 51200)},
        std::pair{"rf64", rf64_bytes(x, as, 51200)},
        std::pair{"w64", w64_bytes(x, as, 51200)}}) {
    const auto file = folder_.write(name, bytes.substr(0, bytes.size() - 700));
    EXPECT_THAT([&] { (void)AudioReader(file); },
                Refuses("ends early: 3600 bytes of samples were announced, "
                        "2900 are there"))
        << name << " was read though it is cut off";
  }
}

// A recorder that writes as it goes does not know yet how long it will be.
TEST_F(SoundContainers, LengthsThatAreNotKnownYetAreTaken) {
  const Eigen::MatrixXd x = steps(16);
  const SoundNumber as{16, false, false};
  const std::string ones(8, '\xff');
  std::string rf64 = rf64_bytes(x, as, 51200);
  // Behind "RF64", length, "WAVE", "ds64" and its length: riff, then data.
  rf64.replace(28, 8, ones);
  std::string w64 = w64_bytes(x, as, 51200);
  w64.replace(w64.find("data") + 16, 8, ones);
  for (const auto& [name, bytes] :
       {std::pair{"rf64", rf64}, std::pair{"w64", w64}}) {
    const auto file = folder_.write(name, bytes);
    EXPECT_FALSE(sample_bytes(file)) << name;
  }
}

// FLAC is compressed: written by libsndfile itself.
TEST_F(SoundContainers, FlacOf16And24Bits) {
  for (const auto& [bits, format] :
       {std::pair{16, SF_FORMAT_PCM_16}, std::pair{24, SF_FORMAT_PCM_24}}) {
    const Eigen::MatrixXd x = steps(bits);
    const auto file = folder_.path() / ("x" + std::to_string(bits) + ".flac");
    SF_INFO info{};
    info.samplerate = 51200;
    info.channels = 3;
    info.format = SF_FORMAT_FLAC | format;
    SNDFILE* handle = sf_open(file.c_str(), SFM_WRITE, &info);
    ASSERT_NE(handle, nullptr);
    const Eigen::Matrix<int, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>
        whole = (x * 2147483648.0).cast<int>();
    ASSERT_EQ(sf_writef_int(handle, whole.data(), x.rows()), x.rows());
    sf_close(handle);
    const Audio audio = read_audio(file);
    EXPECT_EQ(audio.samples, x) << bits;
  }
}

// Written by libsndfile, too; the samples do not matter.
TEST_F(SoundContainers, EncodingsWithLossAreToldOf) {
  struct Case {
    int format;
    const char* name;  ///< nullptr: none is told
  };
  const Case cases[] = {
      {SF_FORMAT_WAV | SF_FORMAT_MS_ADPCM, "ADPCM"},
      {SF_FORMAT_WAV | SF_FORMAT_IMA_ADPCM, "ADPCM"},
      {SF_FORMAT_WAV | SF_FORMAT_GSM610, "GSM"},
      {SF_FORMAT_WAV | SF_FORMAT_ULAW, "U-Law"},
      {SF_FORMAT_WAV | SF_FORMAT_ALAW, "A-Law"},
      {SF_FORMAT_AU | SF_FORMAT_G721_32, "G721"},
      {SF_FORMAT_OGG | SF_FORMAT_VORBIS, "Vorbis"},
      {SF_FORMAT_WAV | SF_FORMAT_PCM_16, nullptr},
      {SF_FORMAT_WAV | SF_FORMAT_FLOAT, nullptr},
      {SF_FORMAT_FLAC | SF_FORMAT_PCM_24, nullptr},
      {SF_FORMAT_CAF | SF_FORMAT_ALAC_24, nullptr},
  };
  TestBundle bundle;
  for (const Case& one : cases) {
    const auto file = folder_.path() / std::to_string(bundle.runs.size());
    SF_INFO info{};
    info.samplerate = 8000;
    info.channels = 1;
    info.format = one.format;
    SNDFILE* handle = sf_open(file.c_str(), SFM_WRITE, &info);
    ASSERT_NE(handle, nullptr) << sf_strerror(nullptr);
    const Eigen::VectorXf x = Eigen::VectorXf::LinSpaced(4000, -0.5F, 0.5F);
    ASSERT_EQ(sf_writef_float(handle, x.data(), x.size()), x.size());
    sf_close(handle);
    acquisition::Run run;
    run.file = file;
    bundle.runs.push_back(run);
    const std::string name = lossy_encoding(file);
    EXPECT_EQ(name.empty(), one.name == nullptr) << name;
    if (one.name != nullptr) {
      EXPECT_THAT(name, HasSubstr(one.name));
    }
  }
  bundle.runs.push_back(bundle.runs.front());
  const std::vector<std::string> said = lossy_statements(bundle);
  EXPECT_EQ(said.size(), 7U);
  EXPECT_TRUE(std::ranges::any_of(said, [](const std::string& text) {
    return text.starts_with("0 and 1 more are compressed with loss") &&
           text.find("PCM WAV or FLAC") != std::string::npos;
  })) << ::testing::PrintToString(said);
}

}  // namespace
}  // namespace tapfit::acquisition
