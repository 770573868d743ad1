#include "acquisition/hits/readable_recordings.hpp"

#include "acquisition/bundle/run_reader.hpp"
#include "acquisition/foundation/input_error.hpp"
#include "acquisition/foundation/input_file.hpp"
#include "acquisition/foundation/parallel.hpp"
#include "acquisition/hits/find_hits.hpp"
#include "acquisition/hits/no_hits.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <optional>
#include <system_error>
#include <utility>

namespace tapfit::acquisition {
namespace {

// Only the runs that are not left out, for as long as it lives: recordings are
// too large to be copied.
class Usable {
 public:
  Usable(const TestBundle& bundle, ReadableRecordings& all)
      : bundle_(bundle), all_(all) {
    bundle_.runs.clear();
    for (std::size_t r = 0; r < bundle.runs.size(); ++r) {
      if (std::ranges::count(all.left_out, r, &LeftOut::run) > 0) continue;
      runs_.push_back(r);
      bundle_.runs.push_back(bundle.runs[r]);
      recordings_.push_back(std::move(all.recordings[r]));
    }
  }
  ~Usable() {
    for (std::size_t k = 0; k < runs_.size(); ++k) {
      all_.recordings[runs_[k]] = std::move(recordings_[k]);
    }
  }
  Usable(const Usable&) = delete;
  Usable& operator=(const Usable&) = delete;

  [[nodiscard]] HitSet hits(const HitOptions& options) const {
    HitSet set = find_hits(bundle_, recordings_, options);
    std::vector<std::vector<Hit>> found = std::move(set.runs);
    set.runs.assign(all_.recordings.size(), {});
    const auto ceilings = std::move(set.ceilings);
    set.ceilings.assign(all_.recordings.size(), std::nullopt);
    for (std::size_t k = 0; k < runs_.size(); ++k) {
      set.runs[runs_[k]] = std::move(found[k]);
      set.ceilings[runs_[k]] = ceilings[k];
    }
    return set;
  }

  /// Leaves out those without a hit.
  /// @return false where none would be left
  [[nodiscard]] bool leave_out(const NoHits& hitless) {
    if (hitless.runs().size() == runs_.size()) return false;
    for (const HitlessRun& one : hitless.runs()) {
      all_.left_out.push_back({runs_[one.run], one.why});
    }
    std::ranges::sort(all_.left_out, {}, &LeftOut::run);
    return true;
  }

 private:
  TestBundle bundle_;
  ReadableRecordings& all_;
  std::vector<std::size_t> runs_;
  std::vector<Recording> recordings_;
};

// Why the first cannot be read, and that no other can.
InputError none_readable(
    const std::vector<std::optional<InputError>>& refused) {
  const InputError& first = *refused.front();
  if (refused.size() == 1) return first;
  const bool alike = std::ranges::all_of(refused, [&](const auto& error) {
    return error->fault() == first.fault();
  });
  return {fmt::format("{}; {} of the {} runs",
                      first.fault(),
                      alike ? "and so in each" : "nor can any other be used",
                      refused.size()),
          first.where(),
          first.remedy()};
}

}  // namespace

std::string statement(const LeftOut& left_out) {
  return fmt::format(
      "run {} is left out: {}", left_out.run + 1, left_out.why.what());
}

void check_run_files(const TestBundle& bundle, Unreadable missing) {
  const auto is_missing = [](const Run& run) {
    std::error_code ignored;
    return !std::filesystem::is_regular_file(run.file, ignored);
  };
  const auto first = std::ranges::find_if(bundle.runs, is_missing);
  if (first == bundle.runs.end()) return;
  const bool all = std::ranges::all_of(bundle.runs, is_missing);
  if (missing == Unreadable::LeftOut && !all) return;
  throw InputError(
      fmt::format(
          "{}{}",
          no_file(first->file),
          all && bundle.runs.size() > 1 ? ", nor that of any other run" : ""),
      fmt::format("test.json: runs[{}].file", first - bundle.runs.begin()),
      "correct the path; it is relative to test.json's folder");
}

ReadableRecordings read_readable(const TestBundle& bundle) {
  const RunReader reader(bundle);
  const std::size_t count = bundle.runs.size();
  ReadableRecordings result;
  result.recordings.resize(count);
  std::vector<std::optional<InputError>> refused(count);
  for_each_parallel(count, [&](std::size_t r) {
    try {
      result.recordings[r] = reader.read(bundle.runs[r]);
    } catch (const InputError& error) {
      refused[r] = error;
    }
  });
  const auto good = std::ranges::find_if(
      refused, [](const auto& error) { return !error.has_value(); });
  if (good == refused.end() && count > 0) throw none_readable(refused);
  double rate = 0.0;
  for (std::size_t r = 0; r < count; ++r) {
    Recording& recording = result.recordings[r];
    if (!refused[r] && rate == 0.0) rate = recording.sample_rate_hz;
    if (!refused[r] && recording.sample_rate_hz == rate) continue;
    result.left_out.push_back(
        {r,
         refused[r]
             ? *refused[r]
             : InputError(fmt::format("is sampled at {} Hz, runs before it at "
                                      "{} Hz",
                                      recording.sample_rate_hz,
                                      rate),
                          bundle.runs[r].file.string(),
                          "resample the file")});
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
  // What is usual among hits changes with the runs that are left.
  while (true) {
    Usable usable(bundle, recordings);
    try {
      return usable.hits(options);
    } catch (const NoHits& hitless) {
      if (!usable.leave_out(hitless)) throw;
    }
  }
}

}  // namespace tapfit::acquisition
