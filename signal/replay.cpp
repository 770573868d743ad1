#include "signal/replay.hpp"

#include "acquisition/input_error.hpp"
#include "acquisition/live_hits.hpp"
#include "acquisition/recording_stream.hpp"
#include "signal/frf_average.hpp"
#include "signal/spectra.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <thread>

namespace tapfit::signal {
namespace {

using acquisition::FoundHits;
using acquisition::Hit;
using acquisition::HitSet;
using acquisition::LiveHits;
using acquisition::LivePiece;
using acquisition::LiveSettings;
using acquisition::Recording;
using acquisition::RecordingStream;
using acquisition::Run;
using acquisition::TestBundle;
using Eigen::Index;

// The beginning of a run, or all of it.
Recording beginning(const TestBundle& bundle, const Run& run, Index samples) {
  RecordingStream stream(bundle, run);
  Recording recording;
  recording.sample_rate_hz = stream.sample_rate_hz();
  recording.samples.resize(std::min(samples, stream.samples()),
                           static_cast<Index>(bundle.channels.size()));
  stream.read(recording.samples);
  return recording;
}

// What is chosen from the beginnings, per run.
std::vector<LiveSettings> trial(const TestBundle& bundle,
                                const ReplayOptions& options) {
  const auto runs = static_cast<Index>(bundle.runs.size());
  const auto channels = static_cast<Index>(bundle.channels.size());
  const Index each =
      options.trial_samples / std::max<Index>(1, runs * channels);
  std::vector<Recording> beginnings;
  for (const Run& run : bundle.runs) {
    beginnings.push_back(beginning(bundle, run, std::max<Index>(1024, each)));
  }
  HitSet set = acquisition::find_hits(bundle, beginnings, options.hits);
  set.runs.assign(bundle.runs.size(), {});
  const auto chosen = [](const auto& mine, const auto& theirs) {
    return mine ? mine : theirs;
  };
  std::vector<LiveSettings> settings;
  for (std::size_t r = 0; r < bundle.runs.size(); ++r) {
    LiveSettings of;
    of.set = set;
    of.slope = acquisition::prepare_run(
                   bundle.runs[r],
                   beginnings[r],
                   chosen(options.hits.trigger.slope, bundle.trigger.slope))
                           .hammer.polarity < 0.0
                   ? -1
                   : 1;
    of.rearm = 0.01 * chosen(options.hits.trigger.rearm_percent,
                             bundle.trigger.rearm_percent)
                          .value_or(50.0);
    of.double_hit_percent = options.hits.double_hit_percent;
    settings.push_back(of);
  }
  return settings;
}

// Rows of a piece: what lies before a new hit, the new hits, and their blocks.
struct PieceLengths {
  Index lead = 0;
  Index own = 0;
  Index tail = 0;
  [[nodiscard]] Index all() const { return lead + own + tail; }
};

PieceLengths lengths_for(const HitSet& set, const FrfPlan& plan, Index room) {
  // As cut_hits() wants them: the quiet before the hit, and some pulse widths.
  const auto quiet = static_cast<Index>(
      std::ceil(4.0 * set.sample_rate_hz / plan.blocks.lowest_hz));
  PieceLengths lengths;
  lengths.lead = set.pre_trigger +
                 std::max({quiet, set.hold_off, set.block / 8, Index{1024}});
  lengths.tail = set.block;
  // Long pieces look at little twice.
  lengths.own = std::max(set.block / 2, room - lengths.lead - lengths.tail);
  return lengths;
}

// Lets the samples come no faster than they would while being measured.
class Pace {
 public:
  explicit Pace(double speed) : speed_(speed) {}
  void wait_until(double recording_s, const Progress& progress) const {
    if (!(speed_ > 0.0)) return;
    using std::chrono::steady_clock;
    const auto due =
        start_ + std::chrono::duration_cast<steady_clock::duration>(
                     std::chrono::duration<double>(recording_s / speed_));
    constexpr std::chrono::milliseconds nap(50);
    while (steady_clock::now() < due) {
      progress("replaying", progress_);
      std::this_thread::sleep_until(std::min(due, steady_clock::now() + nap));
    }
  }
  void at(double share) { progress_ = share; }

 private:
  double speed_;
  double progress_ = 0.0;
  std::chrono::steady_clock::time_point start_ =
      std::chrono::steady_clock::now();
};

/// One run on its way through the pieces.
struct LiveRun {
  const TestBundle& bundle;
  std::size_t index;
  const LiveSettings& settings;
  const FrfPlan& plan;
  const RealFft& fft;
  LiveHits known;
  RunAverage average;
  std::vector<Hit> hits;
};

// Only the accepted new hits go into the average, one at a time, so that the
// blocks of one hit are all that is in memory.
void average_hit(const LivePiece& piece,
                 const FoundHits& found,
                 std::size_t k,
                 LiveRun& run) {
  std::vector<Hit> one = found.hits;
  for (std::size_t i = 0; i < one.size(); ++i) one[i].accepted = i == k;
  const HitBlocks blocks = cut_hits(run.bundle.runs[run.index],
                                    piece.recording,
                                    run.settings.set,
                                    one,
                                    run.plan.blocks);
  add_hits(blocks,
           fft_spectra(
               blocks, run.fft, run.plan.sigma, run.plan.first, run.plan.last),
           run.average);
}

void work_through(const LivePiece& piece,
                  const std::function<void(const LiveHit&)>& on_hit,
                  LiveRun& run) {
  const FoundHits found = find_live_hits(
      run.bundle, run.bundle.runs[run.index], piece, run.settings, run.known);
  for (std::size_t k = 0; k < found.hits.size(); ++k) {
    if (!found.is_new[k]) continue;
    if (found.hits[k].accepted) average_hit(piece, found, k, run);
    Hit hit = found.hits[k];
    hit.begin += piece.start;
    hit.trigger += piece.start;
    run.hits.push_back(hit);
    if (on_hit) on_hit({run.index, run.hits.back(), run.average.hits()});
  }
}

void stream_run(const PieceLengths& lengths,
                const std::function<void(const LiveHit&)>& on_hit,
                const Progress& progress,
                Pace& pace,
                double before_s,
                LiveRun& run) {
  RecordingStream stream(run.bundle, run.bundle.runs[run.index]);
  const auto channels = static_cast<Index>(run.bundle.channels.size());
  LivePiece piece;
  piece.recording.sample_rate_hz = stream.sample_rate_hz();
  Eigen::MatrixXd& samples = piece.recording.samples;
  samples.resize(std::min(lengths.all(), stream.samples()), channels);
  Index filled = 0;
  for (;;) {
    filled += stream.read(samples.bottomRows(samples.rows() - filled));
    const bool ended = piece.start + filled >= stream.samples();
    if (filled < samples.rows()) samples.conservativeResize(filled, channels);
    const double at_s =
        static_cast<double>(piece.start + filled) / stream.sample_rate_hz();
    pace.wait_until(before_s + at_s, progress);
    piece.own_end = ended ? filled : filled - lengths.tail;
    work_through(piece, on_hit, run);
    progress("replaying",
             static_cast<double>(piece.start + filled) /
                 static_cast<double>(stream.samples()));
    if (ended) return;
    // What the next piece needs of this one goes to its front.
    const Index kept =
        filled - std::max<Index>(0, piece.own_end - lengths.lead);
    for (Index c = 0; c < channels; ++c) {
      std::copy(samples.col(c).data() + (filled - kept),
                samples.col(c).data() + filled,
                samples.col(c).data());
    }
    piece.start += filled - kept;
    piece.own_begin = std::min(lengths.lead, piece.own_end);
    filled = kept;
    const Index left = stream.samples() - piece.start;
    if (left < samples.rows()) samples.conservativeResize(left, channels);
  }
}

void check_rate(const TestBundle& bundle, const Run& run, const HitSet& set) {
  const double rate = RecordingStream(bundle, run).sample_rate_hz();
  if (rate == set.sample_rate_hz) return;
  throw InputError(fmt::format("is sampled at {} Hz, the first run at {} Hz",
                               rate,
                               set.sample_rate_hz),
                   run.file.string(),
                   "resample the files to one rate, or make a bundle of each");
}

}  // namespace

Replayed replay(const TestBundle& bundle,
                const ReplayOptions& options,
                const std::function<void(const LiveHit&)>& on_hit,
                const Progress& progress) {
  const std::vector<LiveSettings> settings = trial(bundle, options);
  Replayed result;
  result.hits = settings.at(0).set;
  result.hits.runs.clear();
  const FrfPlan plan = plan_frfs(bundle, result.hits, options.frf);
  const PieceLengths lengths = lengths_for(
      result.hits,
      plan,
      options.piece_samples / static_cast<Index>(bundle.channels.size()));
  result.frfs.s = plan.s;
  const RealFft fft(result.hits.block);
  Pace pace(options.speed);
  double before_s = 0.0;
  for (std::size_t r = 0; r < bundle.runs.size(); ++r) {
    check_rate(bundle, bundle.runs[r], result.hits);
    LiveRun run{bundle, r, settings[r], plan, fft, {}, {}, {}};
    run.average.s = plan.s;
    stream_run(lengths, on_hit, progress, pace, before_s, run);
    before_s +=
        static_cast<double>(RecordingStream(bundle, bundle.runs[r]).samples()) /
        result.hits.sample_rate_hz;
    std::vector<Frf> frfs =
        average_frfs(run.average, bundle, r, options.frf.estimator);
    std::move(frfs.begin(), frfs.end(), std::back_inserter(result.frfs.frfs));
    if (frfs.empty()) {
      result.frfs.statements.push_back(
          fmt::format("run {} ({}) is left out: none of its hits is accepted",
                      r + 1,
                      bundle.runs[r].file.filename().string()));
    }
    result.hits.runs.push_back(std::move(run.hits));
  }
  if (result.frfs.frfs.empty()) {
    throw InputError("no run has an accepted hit",
                     bundle.folder.string(),
                     "look at the reasons with tapfit hits");
  }
  return result;
}

}  // namespace tapfit::signal
