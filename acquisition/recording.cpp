#include "acquisition/recording.hpp"

#include "acquisition/audio_file.hpp"
#include "acquisition/input_error.hpp"
#include "acquisition/parallel.hpp"
#include "acquisition/uff_bundle.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace tapfit::acquisition {
namespace {

// A cable that is off: the converter delivers one value, and an FRF of nothing
// would count as a measurement of nothing.
void check_alive(const Recording& recording,
                 const TestBundle& bundle,
                 const Run& run) {
  std::vector<std::size_t> used = {run.hammer.channel};
  for (const Placement& sensor : run.sensors) used.push_back(sensor.channel);
  for (const std::size_t c : used) {
    const auto channel = recording.samples.col(static_cast<Eigen::Index>(c));
    // Mostly the second sample already differs.
    const double first = channel[0];
    if (std::any_of(channel.begin(), channel.end(), [&](double value) {
          return value != first;
        })) {
      continue;
    }
    throw InputError(
        fmt::format("channel \"{}\" is dead: every sample is {:g} {}",
                    bundle.channels[c].name,
                    first / bundle.channels[c].unit_to_si,
                    bundle.channels[c].unit),
        run.file.string(),
        "record the run again, or take the channel (or the run) "
        "out of `runs`");
  }
}

Recording read_sound(const TestBundle& bundle, const Run& run) {
  AudioReader reader(run.file);
  check_channels(bundle, run, reader.channels());
  const Eigen::RowVectorXd scale = full_scales(bundle);
  Recording recording;
  recording.sample_rate_hz = reader.sample_rate_hz();
  recording.samples = room_for(reader.samples(), reader.channels(), run.file);
  constexpr Eigen::Index at_once = 1 << 12;
  for (Eigen::Index done = 0; done < reader.samples(); done += at_once) {
    auto piece = recording.samples.middleRows(
        done, std::min(at_once, reader.samples() - done));
    reader.read(piece, scale);
    // While they are in the cache.
    if (!reader.floating_point()) continue;
    check_finite(
        piece, done, recording.sample_rate_hz, bundle, run.file.string());
  }
  check_alive(recording, bundle, run);
  check_band(bundle, recording.sample_rate_hz, run.file.string());
  return recording;
}

Recording read_from_uff(const UffFile& file,
                        const TestBundle& bundle,
                        const Run& run) {
  Recording recording = read_uff_run(file, run, bundle.channels.size());
  check_finite(recording.samples,
               0,
               recording.sample_rate_hz,
               bundle,
               run.file.string());
  check_alive(recording, bundle, run);
  check_band(bundle, recording.sample_rate_hz, run.file.string());
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

Eigen::RowVectorXd full_scales(const TestBundle& bundle) {
  Eigen::RowVectorXd scale(static_cast<Eigen::Index>(bundle.channels.size()));
  for (Eigen::Index c = 0; c < scale.size(); ++c) {
    scale(c) = bundle.channels[static_cast<std::size_t>(c)].full_scale_si();
  }
  return scale;
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
  std::vector<Recording> recordings(bundle.runs.size());
  // All runs of a universal file stand in one, which is taken apart once.
  std::optional<UffFile> uff;
  if (bundle.uff) uff.emplace(open_uff(*bundle.uff));
  for_each_parallel(bundle.runs.size(), [&](std::size_t r) {
    const Run& run = bundle.runs[r];
    recordings[r] =
        uff ? read_from_uff(*uff, bundle, run) : read_recording(bundle, run);
  });
  for (std::size_t r = 1; r < recordings.size(); ++r) {
    if (recordings[r].sample_rate_hz == recordings[0].sample_rate_hz) continue;
    throw InputError(
        fmt::format("is sampled at {} Hz, {} at {} Hz",
                    recordings[r].sample_rate_hz,
                    bundle.runs[0].file.string(),
                    recordings[0].sample_rate_hz),
        bundle.runs[r].file.string(),
        "resample the files to one rate, or make a bundle of each");
  }
  return recordings;
}

}  // namespace tapfit::acquisition
