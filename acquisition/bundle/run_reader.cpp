#include "acquisition/bundle/run_reader.hpp"

#include "acquisition/bundle/dead_channels.hpp"
#include "acquisition/foundation/input_error.hpp"
#include "acquisition/foundation/parallel.hpp"
#include "acquisition/readers/audio_file.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace tapfit::acquisition {
namespace {

void check_alive(const Recording& recording,
                 const TestBundle& bundle,
                 const Run& run) {
  DeadChannels dead(bundle, run);
  dead.look_at(recording.samples);
  dead.refuse();
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

RunReader::RunReader(const TestBundle& bundle) : bundle_(bundle) {
  if (bundle.uff) uff_.emplace(open_uff(*bundle.uff));
}

Recording RunReader::read(const Run& run) const {
  if (run.datasets.empty()) return read_sound(bundle_, run);
  return uff_ ? read_from_uff(*uff_, bundle_, run)
              : read_from_uff(open_uff(run.file), bundle_, run);
}

Recording read_recording(const TestBundle& bundle, const Run& run) {
  return RunReader(bundle).read(run);
}

std::vector<Recording> read_recordings(const TestBundle& bundle) {
  std::vector<Recording> recordings(bundle.runs.size());
  const RunReader reader(bundle);
  for_each_parallel(recordings.size(), [&](std::size_t r) {
    recordings[r] = reader.read(bundle.runs[r]);
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
