// From the hammer channel to judged hits: prepare, trigger, group, choose the
// block, judge each hit, and say what was chosen.
#include "acquisition/hits.hpp"

#include "acquisition/choose_block.hpp"
#include "acquisition/compare_hits.hpp"
#include "acquisition/hit_steps.hpp"
#include "acquisition/input_error.hpp"
#include "acquisition/no_hits.hpp"
#include "acquisition/parallel.hpp"
#include "acquisition/remove_offset.hpp"
#include "acquisition/short_pulses.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

namespace tapfit::acquisition {
namespace {

using Eigen::Index;

constexpr double default_trigger = 0.05;  // of the run's largest peak
constexpr double usable_snr = 10.0;       // ... of the largest in a run

double rearm_share(const HitOptions& options) {
  return 0.01 * options.trigger.rearm_percent.value_or(50.0);
}

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
    if (run.hammer.peak > usable_snr * run.hammer.noise) {
      run.pulses.pulses = find_pulses(
          run.hammer.force, run.hammer.pieces, run.level, rearm_share(options));
    }
    if (run.pulses.pulses.empty()) {
      hitless.push_back({r, no_hit(bundle.runs[r], run)});
    }
  }
  if (!hitless.empty()) throw NoHits(std::move(hitless));
}

double usual_width(const std::vector<HammerRun>& work) {
  std::vector<double> widths;
  for (const HammerRun& run : work) {
    for (const Pulse& pulse : run.pulses.pulses) widths.push_back(pulse.width);
  }
  return median(
      Eigen::VectorXd::Map(widths.data(), static_cast<Index>(widths.size())));
}

// The largest hit of those with room enough to watch the response die.
const PulseGroup& clearest_hit(const std::vector<PulseGroup>& groups) {
  Index longest = 0;
  for (const PulseGroup& group : groups) {
    longest = std::max(longest, group.room);
  }
  const PulseGroup* best = nullptr;
  for (const PulseGroup& group : groups) {
    if (2 * group.room < longest) continue;
    if (best == nullptr || group.largest.height > best->largest.height) {
      best = &group;
    }
  }
  return *best;
}

// How long the responses of a run's clearest hit last.
Index lasting_response(const Run& run,
                       const Recording& recording,
                       const PulseGroup& hit) {
  std::vector<Index> lasting(run.sensors.size());
  for_each_parallel(lasting.size(), [&](std::size_t k) {
    const auto channel =
        recording.samples.col(static_cast<Index>(run.sensors[k].channel));
    constexpr Index enough = 1 << 13;
    const double level = median(thinned(channel, enough));
    const Eigen::VectorXd response =
        channel.segment(hit.first.first, hit.room).array() - level;
    lasting[k] = response_length(response);
  });
  return lasting.empty() ? 0
                         : *std::max_element(lasting.begin(), lasting.end());
}

// The longest of all runs.
Index lasting_response(const TestBundle& bundle,
                       const std::vector<Recording>& recordings,
                       const std::vector<HammerRun>& work) {
  std::vector<Index> lasting(work.size());
  for_each_parallel(work.size(), [&](std::size_t r) {
    lasting[r] = lasting_response(
        bundle.runs[r], recordings[r], clearest_hit(work[r].groups));
  });
  return *std::max_element(lasting.begin(), lasting.end());
}

Block block_for(const TestBundle& bundle,
                const std::vector<Recording>& recordings,
                const std::vector<HammerRun>& work,
                const HitOptions& options) {
  const double rate = recordings[0].sample_rate_hz;
  const double low = bundle.band_hz ? (*bundle.band_hz)[0] : 0.0;
  const double high = band_end(bundle, rate);
  // 200 lines in the band and four periods of its lowest frequency.
  double least_s = 200.0 / (high - low);
  if (low > 0.0) least_s = std::max(least_s, 4.0 / low);
  BlockNeeds needs;
  needs.lasting = lasting_response(bundle, recordings, work);
  needs.least = static_cast<Index>(std::ceil(least_s * rate));
  needs.pulse_width = usual_width(work);
  needs.sample_rate_hz = rate;
  std::vector<std::vector<PulseGroup>> groups;
  for (const HammerRun& run : work) groups.push_back(run.groups);
  return choose_block(groups, needs, options);
}

// "2.4 mV, 0.05 % of the range" for a force; empty where no range is declared.
std::string in_volts(const Channel& hammer, double force) {
  const double part = force / std::abs(hammer.full_scale_si());
  if (!(part > 0.0)) return {};
  return fmt::format(" ({:.3g} mV, {:.2g} % of the range)",
                     1e3 * part * hammer.full_scale_volts,
                     100.0 * part);
}

std::string level_reason(const HitOptions& options) {
  if (options.trigger_n) return "as fixed before";
  if (options.trigger.range_percent) return "as asked for";
  if (options.trigger_percent) {
    return fmt::format("{:.2g} % of each run's largest peak",
                       *options.trigger_percent);
  }
  return fmt::format("{:.2g} % of each run's largest peak or 8 times its noise",
                     100.0 * default_trigger);
}

void state_trigger(const TestBundle& bundle,
                   const std::vector<HammerRun>& work,
                   const HitOptions& options,
                   HitSet& set) {
  double highest = 0.0;
  double peak = 0.0;
  set.trigger_n = work[0].level;
  for (const HammerRun& run : work) {
    set.trigger_n = std::min(set.trigger_n, run.level);
    highest = std::max(highest, run.level);
    peak = std::max(peak, run.hammer.peak);
  }
  const Channel& hammer = bundle.channels[bundle.runs[0].hammer.channel];
  set.statements.push_back(
      fmt::format("trigger at {:.3g} to {:.3g} N{}, {} (largest peak of all: "
                  "{:.3g} N); armed again below {:.2g} % of it",
                  set.trigger_n,
                  highest,
                  in_volts(hammer, set.trigger_n),
                  level_reason(options),
                  peak,
                  100.0 * rearm_share(options)));
}

void state_block(const Block& block, const HitOptions& options, HitSet& set) {
  set.statements.push_back(fmt::format(
      "pulses within {:.3g} s belong to one hit: {}",
      static_cast<double>(set.hold_off) / set.sample_rate_hz,
      options.trigger.hold_off_s ? "as asked for"
      : options.block_s          ? "the block"
                                 : "a fifth of the usual time between hits"));
  set.statements.push_back(
      fmt::format("block of {:.4g} s ({} samples), {}; pre-trigger {:.3g} s",
                  static_cast<double>(set.block) / set.sample_rate_hz,
                  set.block,
                  block.reason,
                  static_cast<double>(set.pre_trigger) / set.sample_rate_hz));
}

void state_reach(const TestBundle& bundle, HitSet& set) {
  if (set.judged_to_hz >= band_end(bundle, set.sample_rate_hz)) return;
  set.statements.push_back(fmt::format(
      "no band is given: hits are judged up to {:.3g} Hz, where the "
      "usual one's force has fallen by 10 dB; give band_hz",
      set.judged_to_hz));
}

void state_polarity(const std::vector<HammerRun>& work,
                    const HitOptions& options,
                    HitSet& set) {
  const bool negative =
      std::any_of(work.begin(), work.end(), [](const HammerRun& run) {
        return run.hammer.polarity < 0.0;
      });
  if (!negative || options.trigger.slope) return;
  set.statements.emplace_back(
      "blows are negative in the hammer channel of at least one run: is its "
      "polarity right?");
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
  set.hold_off = hold_off;
  set.judged_to_hz = judged_to(bundle, work, rate);
  state_trigger(bundle, work, options, set);
  state_block(block, options, set);
  state_reach(bundle, set);
  state_polarity(work, options, set);
  const std::string too_short = short_pulse_statement(work, rate);
  if (!too_short.empty()) set.statements.push_back(too_short);
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
    judge_outliers(bundle.runs[r], recordings[r], work[r].hammer, set, hits);
  });
  for (std::size_t r = 0; r < work.size(); ++r) {
    rescue(bundle.runs[r], work[r].hammer.noise, set.runs[r], set.statements);
  }
  return set;
}

void note(Hit& hit, HitFault fault) {
  hit.accepted = false;
  const bool known =
      std::count(hit.reasons.begin(), hit.reasons.end(), fault) > 0;
  if (!known) hit.reasons.push_back(fault);
}

std::string name(HitFault fault) {
  switch (fault) {
    case HitFault::Double:
      return "double";
    case HitFault::Overload:
      return "overload";
    case HitFault::Weak:
      return "weak";
    case HitFault::Soft:
      return "soft";
    case HitFault::Truncated:
      return "truncated";
    case HitFault::Outlier:
      return "outlier";
    case HitFault::ByHand:
      return "by hand";
  }
  return {};
}

void overrule(Hit& hit) {
  const auto has = [&](HitFault fault) {
    return std::find(hit.reasons.begin(), hit.reasons.end(), fault);
  };
  if (has(HitFault::Truncated) != hit.reasons.end()) return;
  hit.accepted = !hit.accepted;
  const auto by_hand = has(HitFault::ByHand);
  if (by_hand == hit.reasons.end()) {
    hit.reasons.push_back(HitFault::ByHand);
  } else {
    hit.reasons.erase(by_hand);
  }
}

}  // namespace tapfit::acquisition
