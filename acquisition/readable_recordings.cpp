#include "acquisition/readable_recordings.hpp"

#include "acquisition/input_error.hpp"
#include "acquisition/parallel.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <optional>
#include <utility>

namespace tapfit::acquisition {
namespace {

// Only the runs that could be read, for as long as it lives: recordings are
// too large to be copied.
class Readable {
 public:
  Readable(const TestBundle& bundle, std::vector<Recording>& all)
      : bundle_(bundle), all_(all) {
    bundle_.runs.clear();
    for (std::size_t r = 0; r < all.size(); ++r) {
      if (all[r].samples.rows() == 0) continue;
      runs_.push_back(r);
      bundle_.runs.push_back(bundle.runs[r]);
      recordings_.push_back(std::move(all[r]));
    }
  }
  ~Readable() {
    for (std::size_t k = 0; k < runs_.size(); ++k) {
      all_[runs_[k]] = std::move(recordings_[k]);
    }
  }
  Readable(const Readable&) = delete;
  Readable& operator=(const Readable&) = delete;

  [[nodiscard]] HitSet hits(const HitOptions& options) const {
    HitSet set = find_hits(bundle_, recordings_, options);
    std::vector<std::vector<Hit>> found = std::move(set.runs);
    set.runs.assign(all_.size(), {});
    for (std::size_t k = 0; k < runs_.size(); ++k) {
      set.runs[runs_[k]] = std::move(found[k]);
    }
    return set;
  }

 private:
  TestBundle bundle_;
  std::vector<Recording>& all_;
  std::vector<std::size_t> runs_;
  std::vector<Recording> recordings_;
};

}  // namespace

std::string statement(const LeftOut& left_out) {
  return fmt::format("run {} is left out: {}", left_out.run + 1, left_out.why);
}

ReadableRecordings read_readable(const TestBundle& bundle) {
  if (bundle.uff) return {read_recordings(bundle), {}};
  const std::size_t count = bundle.runs.size();
  ReadableRecordings result;
  result.recordings.resize(count);
  std::vector<std::optional<InputError>> refused(count);
  for_each_parallel(count, [&](std::size_t r) {
    try {
      result.recordings[r] = read_recording(bundle, bundle.runs[r]);
    } catch (const InputError& error) {
      refused[r] = error;
    }
  });
  const auto good = std::ranges::find_if(
      refused, [](const auto& error) { return !error.has_value(); });
  if (good == refused.end() && count > 0) throw InputError(*refused.front());
  double rate = 0.0;
  for (std::size_t r = 0; r < count; ++r) {
    Recording& recording = result.recordings[r];
    if (!refused[r] && rate == 0.0) rate = recording.sample_rate_hz;
    if (!refused[r] && recording.sample_rate_hz == rate) continue;
    result.left_out.push_back(
        {r,
         refused[r]
             ? refused[r]->what()
             : fmt::format("{}: is sampled at {} Hz, runs before it at {} Hz "
                           "(resample the file)",
                           bundle.runs[r].file.string(),
                           recording.sample_rate_hz,
                           rate)});
    recording.samples.resize(0, 0);
  }
  for (Recording& recording : result.recordings) {
    recording.sample_rate_hz = rate;
  }
  return result;
}

HitSet find_readable_hits(const TestBundle& bundle,
                          ReadableRecordings& recordings,
                          const HitOptions& options) {
  if (recordings.left_out.empty()) {
    return find_hits(bundle, recordings.recordings, options);
  }
  return Readable(bundle, recordings.recordings).hits(options);
}

}  // namespace tapfit::acquisition
