#include "acquisition/audio_file.hpp"

#include "acquisition/input_error.hpp"

#include <fmt/format.h>
#include <sndfile.h>

#include <algorithm>
#include <array>
#include <memory>
#include <regex>
#include <string>

namespace tapfit::acquisition {
namespace {

struct Close {
  void operator()(SNDFILE* handle) const { sf_close(handle); }
};
using Handle = std::unique_ptr<SNDFILE, Close>;
using RowMajor =
    Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;

constexpr Eigen::Index frames_at_once = 1 << 15;

Handle open_to_read(const std::filesystem::path& file, SF_INFO& info) {
  std::error_code ignored;
  if (!std::filesystem::is_regular_file(file, ignored)) {
    throw InputError(
        "there is no such file", file.string(), "correct the path");
  }
  Handle handle(sf_open(file.c_str(), SFM_READ, &info));
  if (!handle) {
    throw InputError(
        fmt::format("cannot be read as a sound file: {}", sf_strerror(nullptr)),
        file.string(),
        "record or convert to WAV, W64, RF64, FLAC, AIFF or CAF");
  }
  return handle;
}

// A WAV or AIFF that ends early is opened without complaint, but libsndfile's
// log then says "data : 1000 (should be 500)": announced and present bytes.
void refuse_cut_file(SNDFILE* handle, const std::filesystem::path& file) {
  std::array<char, 8192> log{};
  sf_command(handle, SFC_GET_LOG_INFO, log.data(), log.size());
  static const std::regex pattern(
      R"((?:data|SSND)\s*:\s*(\d+)\s*\(should be (\d+)\))");
  std::cmatch match;
  if (!std::regex_search(log.data(), match, pattern)) return;
  const unsigned long long announced = std::stoull(match[1].str());
  const unsigned long long present = std::stoull(match[2].str());
  // A recorder that writes as it goes leaves all ones until it is stopped.
  const bool open_ended = announced >= 0xFFFFFF00ULL;
  if (announced <= present || open_ended) return;
  throw InputError(
      fmt::format(
          "ends early: {} bytes of samples were announced, {} are there",
          announced,
          present),
      file.string(),
      "copy the file again, or save it anew with the recording program");
}

}  // namespace

Audio read_audio(const std::filesystem::path& file) {
  SF_INFO info{};
  const Handle handle = open_to_read(file, info);
  refuse_cut_file(handle.get(), file);
  if (info.frames <= 0 || info.samplerate <= 0) {
    throw InputError("holds no samples", file.string(), "record it again");
  }
  Audio audio;
  audio.sample_rate_hz = info.samplerate;
  audio.samples.resize(info.frames, info.channels);
  RowMajor chunk(std::min<Eigen::Index>(frames_at_once, info.frames),
                 info.channels);
  Eigen::Index done = 0;
  while (done < info.frames) {
    const Eigen::Index wanted =
        std::min<Eigen::Index>(chunk.rows(), info.frames - done);
    const Eigen::Index got =
        sf_readf_double(handle.get(), chunk.data(), wanted);
    if (got <= 0) break;
    audio.samples.middleRows(done, got) = chunk.topRows(got);
    done += got;
  }
  if (done < info.frames) {
    throw InputError(
        fmt::format("is damaged or ends early: {} of {} samples can be read",
                    done,
                    info.frames),
        file.string(),
        "copy the file again, or save it anew with the recording program");
  }
  return audio;
}

void write_audio(const std::filesystem::path& file,
                 const Eigen::MatrixXd& samples,
                 int rate,
                 AudioFormat format) {
  SF_INFO info{};
  info.samplerate = rate;
  info.channels = static_cast<int>(samples.cols());
  info.format =
      format == AudioFormat::Flac24  ? SF_FORMAT_FLAC | SF_FORMAT_PCM_24
      : format == AudioFormat::Wav24 ? SF_FORMAT_WAV | SF_FORMAT_PCM_24
                                     : SF_FORMAT_WAV | SF_FORMAT_DOUBLE;
  const Handle handle(sf_open(file.c_str(), SFM_WRITE, &info));
  if (!handle) {
    throw InputError(
        fmt::format("cannot be written: {}", sf_strerror(nullptr)),
        file.string(),
        "choose a folder that can be written to (FLAC: at most 8 channels)");
  }
  // Else what lies beyond full scale would wrap around.
  sf_command(handle.get(), SFC_SET_CLIPPING, nullptr, SF_TRUE);
  for (Eigen::Index done = 0; done < samples.rows();) {
    const Eigen::Index count =
        std::min<Eigen::Index>(frames_at_once, samples.rows() - done);
    const RowMajor chunk = samples.middleRows(done, count);
    if (sf_writef_double(handle.get(), chunk.data(), count) != count) {
      throw InputError("cannot be written to its end",
                       file.string(),
                       "see whether the disk is full");
    }
    done += count;
  }
}

}  // namespace tapfit::acquisition
