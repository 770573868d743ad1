// From the hammer channel to judged hits: prepare, trigger, group, choose the
// block, judge each hit, and say what was chosen.
#include "acquisition/hits/find_hits.hpp"

#include "acquisition/bundle/runs_alike.hpp"
#include "acquisition/foundation/input_error.hpp"
#include "acquisition/foundation/parallel.hpp"
#include "acquisition/hits/block_for.hpp"
#include "acquisition/hits/choose_block.hpp"
#include "acquisition/hits/compare_hits.hpp"
#include "acquisition/hits/double_hits.hpp"
#include "acquisition/hits/hit_statements.hpp"
#include "acquisition/hits/hit_steps.hpp"
#include "acquisition/hits/judge_saturation.hpp"
#include "acquisition/hits/no_hits.hpp"
#include "acquisition/samples/statistics.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

namespace tapfit::acquisition {
namespace {

using Eigen::Index;

constexpr double least_usable_snr = 10.0;  // of the largest peak in a run

double usual_peak(const std::vector<HammerRun>& work) {
  Eigen::VectorXd peaks(static_cast<Index>(work.size()));
  for (std::size_t r = 0; r < work.size(); ++r) {
    peaks[static_cast<Index>(r)] = work[r].hammer.peak;
  }
  return median(peaks);
}

// The level as asked for, or as it has to be.
double trigger_level(const TestBundle& bundle,
                     const Run& run,
                     const HitOptions& options,
                     const HammerSignal& hammer,
                     double usual) {
  if (options.trigger_n) return *options.trigger_n;
  if (options.trigger.range_percent) {
    const double range =
        std::abs(bundle.channels[run.hammer.channel].full_scale_si());
    if (std::isfinite(range)) {
      return 0.01 * *options.trigger.range_percent * range;
    }
    throw InputError(
        "the trigger is given in percent of the hammer's range, "
        "but no range is declared",
        run.file.string(),
        "give trigger_percent, of the largest peak, instead");
  }
  if (options.trigger_percent) {
    return 0.01 * *options.trigger_percent * hammer.peak;
  }
  // One mighty blow in a file must not hide the ordinary ones.
  const double reference = std::min(hammer.peak, 3.0 * usual);
  return std::max(default_trigger * reference, 8.0 * hammer.noise);
}

InputError no_hit(const Run& run, const HammerRun& work) {
  return {
      fmt::format("no hit was found: the hammer channel's largest value is "
                  "{:.3g} N over noise of {:.2g} N, the trigger at {:.3g} N",
                  work.hammer.peak,
                  work.hammer.noise,
                  work.level),
      run.file.string(),
      "see whether the hammer's channel is named rightly, lower the trigger, "
      "or leave this run out"};
}

void trigger(const TestBundle& bundle,
             const HitOptions& options,
             std::vector<HammerRun>& work) {
  const double usual = usual_peak(work);
  std::vector<HitlessRun> hitless;
  for (std::size_t r = 0; r < work.size(); ++r) {
    HammerRun& run = work[r];
    run.level =
        trigger_level(bundle, bundle.runs[r], options, run.hammer, usual);
    if (run.hammer.peak > least_usable_snr * run.hammer.noise) {
      run.pulses.pulses = find_pulses(
          run.hammer.force, run.hammer.pieces, run.level, rearm_share(options));
    }
    if (run.pulses.pulses.empty()) {
      hitless.push_back({r, no_hit(bundle.runs[r], run)});
    }
  }
  if (!hitless.empty()) throw NoHits(std::move(hitless));
}

// What is not given is taken from the bundle.
HitOptions completed(const HitOptions& given, const TestBundle& bundle) {
  HitOptions options = given;
  const auto fill = [](auto& mine, const auto& theirs) {
    if (!mine) mine = theirs;
  };
  fill(options.trigger_percent, bundle.trigger_percent);
  fill(options.pre_trigger_s, bundle.pre_trigger_s);
  fill(options.block_s, bundle.block_s);
  fill(options.trigger.range_percent, bundle.trigger.range_percent);
  fill(options.trigger.slope, bundle.trigger.slope);
  fill(options.trigger.rearm_percent, bundle.trigger.rearm_percent);
  fill(options.trigger.hold_off_s, bundle.trigger.hold_off_s);
  return options;
}

std::vector<ComparedRun> compared(const TestBundle& bundle,
                                  const std::vector<Recording>& recordings,
                                  const std::vector<HammerRun>& work,
                                  const RunGroup& group,
                                  HitSet& set) {
  std::vector<ComparedRun> runs;
  for (const std::size_t r : group) {
    runs.push_back({arranged_as(bundle.runs[group.front()], bundle.runs[r]),
                    &recordings[r],
                    &work[r].hammer,
                    &set.runs[r]});
  }
  return runs;
}

// Of runs of one placement the best of each, where no hit of any is accepted.
void keep_best_rejected(const TestBundle& bundle,
                        const std::vector<HammerRun>& work,
                        const RunGroup& group,
                        HitSet& set) {
  const bool any = std::ranges::any_of(
      group, [&](std::size_t r) { return any_accepted(set.runs[r]); });
  for (const std::size_t r : group) {
    if (!any) {
      keep_best_rejected(
          bundle.runs[r], work[r].hammer.noise, set.runs[r], set.statements);
    } else if (!any_accepted(set.runs[r])) {
      set.statements.push_back(
          fmt::format("{}: every hit was rejected; the run is not used, "
                      "others at the same points are",
                      bundle.runs[r].file.filename().string()));
    }
  }
}

void check_arguments(const TestBundle& bundle,
                     const std::vector<Recording>& recordings) {
  if (bundle.runs.empty() || recordings.size() != bundle.runs.size()) {
    throw InputError("there are no recordings to find hits in",
                     bundle.folder.string(),
                     "list recordings in `runs`; a bundle of ready FRFs has no "
                     "hits");
  }
}

}  // namespace

HitSet find_hits(const TestBundle& bundle,
                 const std::vector<Recording>& recordings,
                 const HitOptions& given) {
  check_arguments(bundle, recordings);
  const HitOptions options = completed(given, bundle);
  std::vector<HammerRun> work(bundle.runs.size());
  for_each_parallel(work.size(), [&](std::size_t r) {
    work[r] = prepare_run(bundle.runs[r], recordings[r], options.trigger.slope);
  });
  trigger(bundle, options, work);
  std::vector<RunPulses> pulses;
  for (const HammerRun& run : work) pulses.push_back(run.pulses);
  const double rate = recordings[0].sample_rate_hz;
  const Index hold_off = choose_hold_off(pulses, rate, options);
  for (HammerRun& run : work) run.groups = group_pulses(run.pulses, hold_off);

  const Block block = block_for(bundle, recordings, work, options);
  HitSet set;
  set.sample_rate_hz = rate;
  set.block = block.samples;
  set.pre_trigger = block.pre_trigger;
  set.block_reason = block.reason;
  set.decay = block.decay;
  set.hold_off = hold_off;
  set.usable_bandwidth_hz = usable_bandwidth(bundle, work, rate);
  state_choices(bundle, work, options, set);
  set.runs.resize(work.size());
  for_each_parallel(work.size(), [&](std::size_t r) {
    std::vector<Hit>& hits = set.runs[r];
    hits = judge_alone(bundle,
                       bundle.runs[r],
                       recordings[r],
                       work[r],
                       set,
                       options.double_hit_percent);
    judge_weak(hits);
  });
  for (std::string& said : double_statements(set)) {
    set.statements.push_back(std::move(said));
  }
  judge_saturation(bundle, work, set);
  const std::vector<RunGroup> groups = runs_alike(bundle);
  for_each_parallel(groups.size(), [&](std::size_t g) {
    judge_outliers(compared(bundle, recordings, work, groups[g], set), set);
  });
  for (const RunGroup& group : groups)
    keep_best_rejected(bundle, work, group, set);
  return set;
}

}  // namespace tapfit::acquisition
