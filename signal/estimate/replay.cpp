#include "signal/estimate/replay.hpp"

#include "acquisition/bundle/recording_stream.hpp"
#include "acquisition/bundle/runs_alike.hpp"
#include "acquisition/bundle/uff_bundle.hpp"
#include "acquisition/foundation/input_error.hpp"
#include "acquisition/hits/find_hits.hpp"
#include "acquisition/hits/live_hits.hpp"
#include "signal/decay/block_advice.hpp"
#include "signal/estimate/frf_average.hpp"
#include "signal/estimate/run_consistency.hpp"
#include "signal/spectra/spectra.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <chrono>
#include <cmath>
#include <numbers>
#include <optional>
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
using acquisition::RunGroup;
using acquisition::TestBundle;
using acquisition::UffFile;
using Eigen::Index;

/// Where the runs come from: files of their own, or one universal file, which
/// is taken apart once.
struct Source {
  const TestBundle& bundle;
  std::optional<UffFile> uff;

  explicit Source(const TestBundle& of) : bundle(of) {
    if (of.uff) uff.emplace(acquisition::open_uff(*of.uff));
  }
  [[nodiscard]] RecordingStream stream(std::size_t run) const {
    return {bundle, bundle.runs.at(run), uff ? &*uff : nullptr};
  }
};

// The beginning of a run, or all of it.
Recording beginning(const Source& source, std::size_t run, Index samples) {
  RecordingStream stream = source.stream(run);
  Recording recording;
  recording.sample_rate_hz = stream.sample_rate_hz();
  recording.samples.resize(std::min(samples, stream.samples()),
                           static_cast<Index>(source.bundle.channels.size()));
  stream.read(recording.samples);
  return recording;
}

// What is chosen from the beginnings, per run.
std::vector<LiveSettings> trial(const Source& source,
                                const ReplayOptions& options) {
  const TestBundle& bundle = source.bundle;
  const auto runs = static_cast<Index>(bundle.runs.size());
  const auto channels = static_cast<Index>(bundle.channels.size());
  const Index each =
      options.trial_samples / std::max<Index>(1, runs * channels);
  const Index most = std::max<Index>(1024, each);
  std::vector<Recording> beginnings;
  for (std::size_t r = 0; r < bundle.runs.size(); ++r) {
    beginnings.push_back(beginning(source, r, most));
  }
  HitSet set = acquisition::find_hits(bundle, beginnings, options.hits);
  if (std::ranges::any_of(beginnings, [most](const Recording& of) {
        return of.samples.rows() == most;
      })) {
    set.statements.push_back(fmt::format(
        "these were chosen from the first {:.4g} s of each run; hits and frf "
        "look at the whole of it, and may choose another level and block",
        static_cast<double>(most) / set.sample_rate_hz));
  }
  set.runs.assign(bundle.runs.size(), {});
  const auto ceilings = std::move(set.ceilings);
  const auto chosen = [](const auto& mine, const auto& theirs) {
    return mine ? mine : theirs;
  };
  std::vector<LiveSettings> settings;
  for (std::size_t r = 0; r < bundle.runs.size(); ++r) {
    LiveSettings of;
    of.set = set;
    of.ceiling = ceilings[r];
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
  /// @param run_s since the run began
  /// @param share of the run, for the progress
  void wait_until(double run_s, double share, const Progress& progress) const {
    if (!(speed_ > 0.0)) return;
    using std::chrono::steady_clock;
    const auto due =
        start_ +
        std::chrono::duration_cast<steady_clock::duration>(
            std::chrono::duration<double>((before_s_ + run_s) / speed_));
    constexpr std::chrono::milliseconds nap(50);
    while (steady_clock::now() < due) {
      progress("replaying", share);
      std::this_thread::sleep_until(std::min(due, steady_clock::now() + nap));
    }
  }
  void end_run(double run_s) { before_s_ += run_s; }

 private:
  double speed_;
  double before_s_ = 0.0;
  std::chrono::steady_clock::time_point start_ =
      std::chrono::steady_clock::now();
};

/// What runs of one placement have in common.
struct LiveGroup {
  RunGroup runs;
  std::vector<RunPowers> heard{};  ///< of runs with an accepted hit
  LiveHits known{};
  RunAverage average{};
};

std::vector<LiveGroup> live_groups(const TestBundle& bundle,
                                   const FrfPlan& plan) {
  std::vector<LiveGroup> groups;
  for (RunGroup& runs : acquisition::runs_alike(bundle)) {
    groups.push_back({.runs = std::move(runs)});
    groups.back().average.s = plan.s;
  }
  return groups;
}

LiveGroup& group_of(std::vector<LiveGroup>& groups, std::size_t run) {
  return *std::ranges::find_if(groups, [run](const LiveGroup& group) {
    return std::ranges::count(group.runs, run) > 0;
  });
}

/// One run on its way through the pieces.
struct LiveRun {
  const TestBundle& bundle;
  std::size_t index;
  Run run;  ///< sensors in the order of its group's first
  const LiveSettings& settings;
  const FrfPlan& plan;
  const RealFft& fft;
  std::array<double, 2> band_hz;
  LiveGroup& group;
  std::vector<Hit> hits{};
  Index samples = 0;
  double strongest_n = 0.0;  ///< of the accepted hits
  DecayCheck lasting{};      ///< of that one
};

// The run's own sums, where there are others to compare them with.
void keep(const std::vector<CrossPowers>& hit, LiveRun& run) {
  std::vector<RunPowers>& heard = run.group.heard;
  const RunGroup& runs = run.group.runs;
  const auto place = static_cast<std::size_t>(
      std::ranges::find(runs, run.index) - runs.begin());
  if (heard.empty() || heard.back().place != place) {
    heard.push_back({place, std::vector<CrossPowers>(hit.size())});
  }
  if (runs.size() < 2) return;
  for (std::size_t c = 0; c < hit.size(); ++c) heard.back().powers[c] += hit[c];
}

// Only the accepted new hits go into the average, one at a time, so that the
// blocks of one hit are all that is in memory.
void average_hit(const LivePiece& piece,
                 const FoundHits& found,
                 std::size_t k,
                 LiveRun& run) {
  std::vector<Hit> one = found.hits;
  for (std::size_t i = 0; i < one.size(); ++i) one[i].accepted = i == k;
  const HitBlocks blocks = cut_hits(
      run.run, piece.recording, run.settings.set, one, run.plan.blocks);
  RunAverage hit;
  hit.s = run.plan.s;
  add_hits(blocks,
           fft_spectra(
               blocks, run.fft, run.plan.sigma, run.plan.first, run.plan.last),
           hit);
  add_hits(hit, run.group.average);
  keep(hit.powers, run);
  if (found.hits[k].peak_n <= run.strongest_n) return;
  run.strongest_n = found.hits[k].peak_n;
  run.lasting = check_decay(blocks, run.band_hz);
}

void work_through(const LivePiece& piece,
                  const std::function<void(const LiveHit&)>& on_hit,
                  LiveRun& run) {
  const FoundHits found =
      find_live_hits(run.bundle, run.run, piece, run.settings, run.group.known);
  for (std::size_t k = 0; k < found.hits.size(); ++k) {
    if (!found.is_new[k]) continue;
    if (found.hits[k].accepted) average_hit(piece, found, k, run);
    Hit hit = found.hits[k];
    hit.begin += piece.start;
    hit.trigger += piece.start;
    run.hits.push_back(hit);
    if (on_hit) on_hit({run.index, run.hits.back(), run.group.average.hits()});
  }
}

void stream_run(RecordingStream stream,
                const PieceLengths& lengths,
                const std::function<void(const LiveHit&)>& on_hit,
                const Progress& progress,
                const Pace& pace,
                LiveRun& run) {
  run.samples = stream.samples();
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
    const auto at = static_cast<double>(piece.start + filled);
    const double share = at / static_cast<double>(stream.samples());
    pace.wait_until(at / stream.sample_rate_hz(), share, progress);
    piece.own_end = ended ? filled : filled - lengths.tail;
    work_through(piece, on_hit, run);
    progress("replaying", share);
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

std::array<double, 2> band_of(const FrfPlan& plan) {
  return {plan.s(0).imag() / (2.0 * std::numbers::pi),
          plan.s(plan.s.size() - 1).imag() / (2.0 * std::numbers::pi)};
}

void check_rate(const RecordingStream& stream,
                const Run& run,
                const HitSet& set) {
  if (stream.sample_rate_hz() == set.sample_rate_hz) return;
  throw InputError(fmt::format("is sampled at {} Hz, the first run at {} Hz",
                               stream.sample_rate_hz(),
                               set.sample_rate_hz),
                   run.file.string(),
                   "resample the files to one rate, or make a bundle of each");
}

// What is said of the runs as a whole: blocks that are too short go first.
void add_statements(const TestBundle& bundle,
                    const FrfPlan& plan,
                    const std::vector<Index>& samples,
                    const DecayCheck& lasting,
                    Replayed& result) {
  std::vector<std::string>& said = result.frfs.statements;
  said = lasting_statements(
      lasting, result.hits, samples, band_of(plan), plan.sigma);
  for (std::size_t r = 0; r < bundle.runs.size(); ++r) {
    const auto& hits = result.hits.runs[r];
    if (std::ranges::any_of(hits, &Hit::accepted)) continue;
    said.push_back(
        fmt::format("run {} ({}) is left out: none of its hits is accepted",
                    r + 1,
                    bundle.runs[r].file.filename().string()));
  }
}

}  // namespace

Replayed replay(const TestBundle& bundle,
                const ReplayOptions& options,
                const std::function<void(const LiveHit&)>& on_hit,
                const Progress& progress) {
  const Source source(bundle);
  const std::vector<LiveSettings> settings = trial(source, options);
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
  DecayCheck lasting;
  std::vector<Index> samples;
  std::vector<LiveGroup> groups = live_groups(bundle, plan);
  for (std::size_t r = 0; r < bundle.runs.size(); ++r) {
    RecordingStream stream = source.stream(r);
    check_rate(stream, bundle.runs[r], result.hits);
    LiveGroup& group = group_of(groups, r);
    LiveRun run{
        .bundle = bundle,
        .index = r,
        .run = arranged_as(bundle.runs[group.runs.front()], bundle.runs[r]),
        .settings = settings[r],
        .plan = plan,
        .fft = fft,
        .band_hz = band_of(plan),
        .group = group};
    begin_run(group.known);
    stream_run(std::move(stream), lengths, on_hit, progress, pace, run);
    pace.end_run(static_cast<double>(run.samples) / result.hits.sample_rate_hz);
    result.hits.runs.push_back(std::move(run.hits));
    lasting.join(run.lasting);
    samples.push_back(run.samples);
  }
  for (const LiveGroup& group : groups) {
    std::vector<Frf> frfs = average_frfs(
        group.average, bundle, group.runs.front(), options.frf.estimator);
    for (Frf& frf : frfs) frf.run = group.runs[group.heard.front().place];
    std::move(frfs.begin(), frfs.end(), std::back_inserter(result.frfs.frfs));
  }
  if (result.frfs.frfs.empty()) {
    throw InputError("no run has an accepted hit",
                     bundle.folder.string(),
                     "look at the reasons with tapfit hits");
  }
  add_statements(bundle, plan, samples, lasting, result);
  for (const LiveGroup& group : groups) {
    if (const auto difference = run_inconsistency(group.heard)) {
      result.frfs.statements.push_back(
          in_full(finding_of(*difference, bundle, group.runs)));
    }
  }
  return result;
}

}  // namespace tapfit::signal
