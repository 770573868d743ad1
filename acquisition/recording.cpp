#include "acquisition/recording.hpp"

#include "acquisition/audio_file.hpp"
#include "acquisition/input_error.hpp"

#include <fmt/format.h>

#include <cmath>

namespace tapfit::acquisition {
namespace {

void check_finite(const Audio& audio,
                  const TestBundle& bundle,
                  const std::string& file) {
  if (audio.samples.allFinite()) return;
  for (Eigen::Index c = 0; c < audio.samples.cols(); ++c) {
    for (Eigen::Index i = 0; i < audio.samples.rows(); ++i) {
      if (std::isfinite(audio.samples(i, c))) continue;
      throw InputError(
          fmt::format("channel \"{}\" is not a number at {:.6f} s",
                      bundle.channels[static_cast<std::size_t>(c)].name,
                      static_cast<double>(i) / audio.sample_rate_hz),
          file,
          "record or export the file again, or leave this run out");
    }
  }
}

// A cable that is off: the converter delivers one value, and an FRF of nothing
// would count as a measurement of nothing.
void check_alive(const Audio& audio,
                 const TestBundle& bundle,
                 const Run& run,
                 const std::string& file) {
  std::vector<std::size_t> used = {run.hammer.channel};
  for (const Placement& sensor : run.sensors) used.push_back(sensor.channel);
  for (const std::size_t c : used) {
    const auto samples = audio.samples.col(static_cast<Eigen::Index>(c));
    if (samples.maxCoeff() > samples.minCoeff()) continue;
    throw InputError(
        fmt::format("channel \"{}\" is dead: every sample is {:g}",
                    bundle.channels[c].name,
                    samples(0)),
        file,
        "record the run again, or take the channel (or the run) out of `runs`");
  }
}

void check_band(const TestBundle& bundle,
                double rate,
                const std::string& file) {
  if (!bundle.band_hz || (*bundle.band_hz)[1] < 0.5 * rate) return;
  throw InputError(
      fmt::format("the band ends at {} Hz, but {} is sampled at {} Hz and "
                  "holds only frequencies below {} Hz",
                  (*bundle.band_hz)[1],
                  file,
                  rate,
                  0.5 * rate),
      "test.json: band_hz",
      "lower the band's upper end");
}

}  // namespace

Recording read_recording(const TestBundle& bundle, const Run& run) {
  Audio audio = read_audio(run.file);
  const std::string file = run.file.string();
  const auto channels = static_cast<Eigen::Index>(bundle.channels.size());
  if (audio.samples.cols() != channels) {
    throw InputError(fmt::format("has {} channels, test.json lists {}",
                                 audio.samples.cols(),
                                 channels),
                     file,
                     "list in `channels` every channel of the file, in order");
  }
  check_finite(audio, bundle, file);
  check_alive(audio, bundle, run, file);
  check_band(bundle, audio.sample_rate_hz, file);
  Recording recording;
  recording.sample_rate_hz = audio.sample_rate_hz;
  recording.samples = std::move(audio.samples);
  for (Eigen::Index c = 0; c < channels; ++c) {
    recording.samples.col(c) *=
        bundle.channels[static_cast<std::size_t>(c)].full_scale_si();
  }
  return recording;
}

std::vector<Recording> read_recordings(const TestBundle& bundle) {
  std::vector<Recording> recordings;
  recordings.reserve(bundle.runs.size());
  for (const Run& run : bundle.runs) {
    recordings.push_back(read_recording(bundle, run));
    if (recordings.back().sample_rate_hz == recordings[0].sample_rate_hz) {
      continue;
    }
    throw InputError(
        fmt::format("is sampled at {} Hz, {} at {} Hz",
                    recordings.back().sample_rate_hz,
                    bundle.runs[0].file.string(),
                    recordings[0].sample_rate_hz),
        run.file.string(),
        "resample the files to one rate, or make a bundle of each");
  }
  return recordings;
}

}  // namespace tapfit::acquisition
