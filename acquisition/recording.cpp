#include "acquisition/recording.hpp"

#include "acquisition/audio_file.hpp"
#include "acquisition/input_error.hpp"
#include "acquisition/uff_bundle.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace tapfit::acquisition {
namespace {

// What a recording's checks need, gathered while its samples are in the cache.
struct Extremes {
  Eigen::RowVectorXd low;
  Eigen::RowVectorXd high;
  double sum = 0.0;  // not finite where any sample is not

  void take(const Eigen::Ref<const Eigen::MatrixXd>& piece) {
    if (low.size() == 0) {
      low = high = piece.row(0);
    }
    for (Eigen::Index c = 0; c < piece.cols(); ++c) {
      low(c) = std::min(low(c), piece.col(c).minCoeff());
      high(c) = std::max(high(c), piece.col(c).maxCoeff());
      sum += piece.col(c).sum();
    }
  }
};

// A cable that is off: the converter delivers one value, and an FRF of nothing
// would count as a measurement of nothing.
void check_alive(const Extremes& extremes,
                 const TestBundle& bundle,
                 const Run& run) {
  std::vector<std::size_t> used = {run.hammer.channel};
  for (const Placement& sensor : run.sensors) used.push_back(sensor.channel);
  for (const std::size_t c : used) {
    const auto column = static_cast<Eigen::Index>(c);
    if (extremes.high(column) > extremes.low(column)) continue;
    throw InputError(
        fmt::format("channel \"{}\" is dead: every sample is {:g} {}",
                    bundle.channels[c].name,
                    extremes.low(column) / bundle.channels[c].unit_to_si,
                    bundle.channels[c].unit),
        run.file.string(),
        "record the run again, or take the channel (or the run) out of `runs`");
  }
}

void check(const Recording& recording,
           const Extremes& extremes,
           const TestBundle& bundle,
           const Run& run) {
  const std::string file = run.file.string();
  if (!std::isfinite(extremes.sum)) {
    check_finite(recording.samples, 0, recording.sample_rate_hz, bundle, file);
  }
  check_alive(extremes, bundle, run);
  check_band(bundle, recording.sample_rate_hz, file);
}

Recording read_sound(const TestBundle& bundle, const Run& run) {
  AudioReader reader(run.file);
  check_channels(bundle, run, reader.channels());
  Eigen::RowVectorXd scale(reader.channels());
  for (Eigen::Index c = 0; c < scale.size(); ++c) {
    scale(c) = bundle.channels[static_cast<std::size_t>(c)].full_scale_si();
  }
  Recording recording;
  recording.sample_rate_hz = reader.sample_rate_hz();
  recording.samples = room_for(reader, run.file);
  Extremes extremes;
  constexpr Eigen::Index at_once = 1 << 12;
  for (Eigen::Index done = 0; done < reader.samples(); done += at_once) {
    auto piece = recording.samples.middleRows(
        done, std::min(at_once, reader.samples() - done));
    reader.read(piece);
    piece.array().rowwise() *= scale.array();
    extremes.take(piece);
  }
  check(recording, extremes, bundle, run);
  return recording;
}

Recording read_from_uff(const UffFile& file,
                        const TestBundle& bundle,
                        const Run& run) {
  Recording recording = read_uff_run(file, run, bundle.channels.size());
  Extremes extremes;
  extremes.take(recording.samples);
  check(recording, extremes, bundle, run);
  return recording;
}

}  // namespace

void check_finite(const Eigen::Ref<const Eigen::MatrixXd>& samples,
                  Eigen::Index first,
                  double rate,
                  const TestBundle& bundle,
                  const std::string& file) {
  // One sum per column shows what is not finite without looking at each.
  if (std::isfinite(samples.sum())) return;
  for (Eigen::Index c = 0; c < samples.cols(); ++c) {
    for (Eigen::Index i = 0; i < samples.rows(); ++i) {
      if (std::isfinite(samples(i, c))) continue;
      throw InputError(
          fmt::format("channel \"{}\" is not a number at {:.6f} s",
                      bundle.channels[static_cast<std::size_t>(c)].name,
                      static_cast<double>(first + i) / rate),
          file,
          "record or export the file again, or leave this run out");
    }
  }
}

void check_channels(const TestBundle& bundle,
                    const Run& run,
                    Eigen::Index channels) {
  if (channels == static_cast<Eigen::Index>(bundle.channels.size())) return;
  throw InputError(fmt::format("has {} channels, test.json lists {}",
                               channels,
                               bundle.channels.size()),
                   run.file.string(),
                   "list in `channels` every channel of the file, in order");
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

Recording read_recording(const TestBundle& bundle, const Run& run) {
  return run.datasets.empty() ? read_sound(bundle, run)
                              : read_from_uff(open_uff(run.file), bundle, run);
}

std::vector<Recording> read_recordings(const TestBundle& bundle) {
  std::vector<Recording> recordings;
  recordings.reserve(bundle.runs.size());
  // All runs of a universal file stand in one, which is taken apart once.
  std::optional<UffFile> uff;
  if (bundle.uff) uff.emplace(open_uff(*bundle.uff));
  for (const Run& run : bundle.runs) {
    recordings.push_back(uff ? read_from_uff(*uff, bundle, run)
                             : read_recording(bundle, run));
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
