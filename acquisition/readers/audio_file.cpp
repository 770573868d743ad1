#include "acquisition/readers/audio_file.hpp"

#include "acquisition/foundation/input_error.hpp"
#include "acquisition/foundation/input_file.hpp"
#include "acquisition/foundation/large_pages.hpp"
#include "acquisition/readers/sample_bytes.hpp"

#include <fmt/format.h>
#include <sndfile.h>

#include <algorithm>
#include <array>
#include <memory>
#include <mutex>
#include <new>
#include <optional>
#include <regex>
#include <string>
#include <vector>

namespace tapfit::acquisition {
namespace {

struct Close {
  void operator()(SNDFILE* handle) const { sf_close(handle); }
};
using Handle = std::unique_ptr<SNDFILE, Close>;
using RowMajor =
    Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;

// Small enough to stay in the cache while it is turned into columns.
constexpr Eigen::Index frames_at_once = 1 << 10;

// Column by column: each is written in one go, and what is read stays near.
void into_columns(const Eigen::Ref<const RowMajor>& chunk,
                  const Eigen::RowVectorXd& scale,
                  Eigen::Ref<Eigen::MatrixXd> out) {
  const Eigen::Index channels = chunk.cols();
  for (Eigen::Index c = 0; c < channels; ++c) {
    const double* from = chunk.data() + c;
    double* to = out.col(c).data();
    const double factor = scale(c);
    for (Eigen::Index i = 0; i < chunk.rows(); ++i, from += channels) {
      to[i] = factor * *from;
    }
  }
}

Handle open_to_read(const std::filesystem::path& file, SF_INFO& info) {
  std::error_code ignored;
  if (!std::filesystem::exists(file, ignored)) {
    throw InputError(
        "there is no such file", file.string(), "correct the path");
  }
  check_input(file);
  // Several runs are read at a time, but the reason of a refusal is kept in one
  // place for all.
  static std::mutex reason;
  const std::lock_guard guard(reason);
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
std::optional<SampleBytes> logged_bytes(SNDFILE* handle) {
  std::array<char, 8192> log{};
  sf_command(handle, SFC_GET_LOG_INFO, log.data(), log.size());
  static const std::regex pattern(
      R"((?:data|SSND)\s*:\s*(\d+)\s*\(should be (\d+)\))");
  std::cmatch match;
  if (!std::regex_search(log.data(), match, pattern)) return std::nullopt;
  const SampleBytes found{std::stoull(match[1].str()),
                          std::stoull(match[2].str())};
  // A recorder that writes as it goes leaves all ones until it is stopped.
  const bool open_ended = found.announced >= 0xFFFFFF00ULL;
  return open_ended ? std::nullopt : std::optional(found);
}

void refuse_cut_file(SNDFILE* handle, const std::filesystem::path& file) {
  std::optional<SampleBytes> found = sample_bytes(file);
  if (!found) found = logged_bytes(handle);
  if (!found || found->announced <= found->present) return;
  throw InputError(
      fmt::format(
          "ends early: {} bytes of samples were announced, {} are there",
          found->announced,
          found->present),
      file.string(),
      "copy the file again, or save it anew with the recording program");
}

// No format takes less than 11 bytes for 65,535 samples (FLAC, of silence).
// Room for more than that must not be made.
void refuse_tall_tale(sf_count_t frames, const std::filesystem::path& file) {
  std::error_code ignored;
  const auto size =
      static_cast<double>(std::filesystem::file_size(file, ignored));
  if (ignored || static_cast<double>(frames) <= 6000.0 * size) return;
  throw InputError(
      fmt::format("announces {} samples in {} bytes", frames, size),
      file.string(),
      "it is damaged: copy it again, or save it anew");
}

InputError ends_early(const std::filesystem::path& file,
                      Eigen::Index done,
                      Eigen::Index announced) {
  return {fmt::format("is damaged or ends early: {} of {} samples can be read",
                      done,
                      announced),
          file.string(),
          "copy the file again, or save it anew with the recording program"};
}

// Whether samples come back as they were written. FLAC counts as PCM.
bool keeps_samples(int subtype) {
  switch (subtype) {
    case SF_FORMAT_PCM_S8:
    case SF_FORMAT_PCM_U8:
    case SF_FORMAT_PCM_16:
    case SF_FORMAT_PCM_24:
    case SF_FORMAT_PCM_32:
    case SF_FORMAT_FLOAT:
    case SF_FORMAT_DOUBLE:
    case SF_FORMAT_DWVW_12:
    case SF_FORMAT_DWVW_16:
    case SF_FORMAT_DWVW_24:
    case SF_FORMAT_DWVW_N:
    case SF_FORMAT_DPCM_8:
    case SF_FORMAT_DPCM_16:
    case SF_FORMAT_ALAC_16:
    case SF_FORMAT_ALAC_20:
    case SF_FORMAT_ALAC_24:
    case SF_FORMAT_ALAC_32:
      return true;
    default:
      return false;
  }
}

InputError unwritten(const std::filesystem::path& file) {
  return {"cannot be written to its end",
          file.string(),
          "see whether the disk is full"};
}

// libsndfile does not tell of what it could not write when it closes a file.
void check_end(const std::filesystem::path& file, Eigen::Index samples) {
  SF_INFO info{};
  const Handle handle(sf_open(file.c_str(), SFM_READ, &info));
  if (!handle || info.frames != samples) throw unwritten(file);
  if (samples == 0) return;
  std::vector<double> last(static_cast<std::size_t>(info.channels));
  if (sf_seek(handle.get(), samples - 1, SEEK_SET) != samples - 1 ||
      sf_readf_double(handle.get(), last.data(), 1) != 1) {
    throw unwritten(file);
  }
}

}  // namespace

struct AudioReader::State {
  std::filesystem::path file;
  SF_INFO info{};
  Handle handle;
  Eigen::Index done = 0;
  RowMajor chunk;
};

AudioReader::AudioReader(const std::filesystem::path& file)
    : state_(std::make_unique<State>()) {
  state_->file = file;
  state_->handle = open_to_read(file, state_->info);
  refuse_cut_file(state_->handle.get(), file);
  if (state_->info.frames <= 0 || state_->info.samplerate <= 0) {
    throw InputError("holds no samples", file.string(), "record it again");
  }
  refuse_tall_tale(state_->info.frames, file);
}

AudioReader::~AudioReader() = default;
AudioReader::AudioReader(AudioReader&&) noexcept = default;
AudioReader& AudioReader::operator=(AudioReader&&) noexcept = default;

double AudioReader::sample_rate_hz() const { return state_->info.samplerate; }
Eigen::Index AudioReader::samples() const { return state_->info.frames; }
Eigen::Index AudioReader::channels() const { return state_->info.channels; }

bool AudioReader::floating_point() const {
  switch (state_->info.format & SF_FORMAT_SUBMASK) {
    case SF_FORMAT_PCM_S8:
    case SF_FORMAT_PCM_U8:
    case SF_FORMAT_PCM_16:
    case SF_FORMAT_PCM_24:
    case SF_FORMAT_PCM_32:
      return false;
    default:
      return true;
  }
}

Eigen::Index AudioReader::read(Eigen::Ref<Eigen::MatrixXd> out,
                               const Eigen::RowVectorXd& scale) {
  const Eigen::Index wanted =
      std::min<Eigen::Index>(out.rows(), samples() - state_->done);
  state_->chunk.resize(
      std::min(frames_at_once, std::max<Eigen::Index>(1, wanted)), channels());
  Eigen::Index filled = 0;
  while (filled < wanted) {
    const Eigen::Index count =
        std::min<Eigen::Index>(state_->chunk.rows(), wanted - filled);
    const Eigen::Index got =
        sf_readf_double(state_->handle.get(), state_->chunk.data(), count);
    if (got <= 0) {
      throw ends_early(state_->file, state_->done, samples());
    }
    into_columns(
        state_->chunk.topRows(got), scale, out.middleRows(filled, got));
    filled += got;
    state_->done += got;
  }
  return filled;
}

std::string lossy_encoding(const std::filesystem::path& file) {
  std::error_code ignored;
  if (!std::filesystem::is_regular_file(file, ignored)) return {};
  SF_INFO info{};
  const Handle handle(sf_open(file.c_str(), SFM_READ, &info));
  const int subtype = info.format & SF_FORMAT_SUBMASK;
  if (!handle || keeps_samples(subtype)) return {};
  SF_FORMAT_INFO about{};
  about.format = subtype;
  const bool named =
      sf_command(nullptr, SFC_GET_FORMAT_INFO, &about, sizeof(about)) == 0 &&
      about.name != nullptr;
  return named ? about.name : fmt::format("libsndfile's {:#x}", subtype);
}

Eigen::MatrixXd room_for(Eigen::Index samples,
                         Eigen::Index channels,
                         const std::filesystem::path& file) {
  const double bytes = sizeof(double) * static_cast<double>(samples) *
                       static_cast<double>(channels);
  try {
    if (bytes > most_matrix_bytes()) throw std::bad_alloc();
    Eigen::MatrixXd room(samples, channels);
    prefer_large_pages(room);
    return room;
  } catch (const std::bad_alloc&) {
    throw InputError(
        fmt::format("announces {} samples of {} channels, more than memory "
                    "holds",
                    samples,
                    channels),
        file.string(),
        "work through it with tapfit replay; or, if it is not that long, it is "
        "damaged: copy it again");
  }
}

Audio read_audio(const std::filesystem::path& file) {
  AudioReader reader(file);
  Audio audio;
  audio.sample_rate_hz = reader.sample_rate_hz();
  audio.samples = room_for(reader.samples(), reader.channels(), file);
  reader.read(audio.samples, Eigen::RowVectorXd::Ones(reader.channels()));
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
  Handle handle(sf_open(file.c_str(), SFM_WRITE, &info));
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
      throw unwritten(file);
    }
    done += count;
  }
  handle.reset();
  check_end(file, samples.rows());
}

std::string sound_library() {
  const std::string name = sf_version_string();  // "libsndfile-1.2.0"
  return name.substr(name.find('-') + 1);
}

}  // namespace tapfit::acquisition
