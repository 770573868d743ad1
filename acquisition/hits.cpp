// From the hammer channel to judged hits: prepare, trigger, group, choose the
// block, judge each hit, and say what was chosen.
#include "acquisition/hits.hpp"

#include "acquisition/choose_block.hpp"
#include "acquisition/compare_hits.hpp"
#include "acquisition/input_error.hpp"
#include "acquisition/judge_hits.hpp"
#include "acquisition/remove_offset.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace tapfit::acquisition {
namespace {

using Eigen::Index;

constexpr double default_trigger = 0.05;  // of the run's largest peak
constexpr double least_snr = 20.0;        // peak over noise of a good hit
constexpr double usable_snr = 10.0;       // ... of the largest in a run
constexpr double softest_db = -20.0;      // at the band's end (ISO 7626-5)

/// One run on its way through the steps.
struct WorkingRun {
  HammerSignal hammer;
  double level = 0.0;
  RunPulses pulses;
  std::vector<PulseGroup> groups;
};

void prepare(const TestBundle& bundle,
             const std::vector<Recording>& recordings,
             std::vector<WorkingRun>& work) {
  for (std::size_t r = 0; r < bundle.runs.size(); ++r) {
    const auto channel = static_cast<Index>(bundle.runs[r].hammer.channel);
    WorkingRun run;
    run.hammer = prepare_hammer(recordings[r].samples.col(channel),
                                recordings[r].sample_rate_hz);
    run.pulses.samples = recordings[r].samples.rows();
    work.push_back(std::move(run));
  }
}

double usual_peak(const std::vector<WorkingRun>& work) {
  Eigen::VectorXd peaks(static_cast<Index>(work.size()));
  for (std::size_t r = 0; r < work.size(); ++r) {
    peaks[static_cast<Index>(r)] = work[r].hammer.peak;
  }
  return median(peaks);
}

void trigger(const TestBundle& bundle,
             const HitOptions& options,
             std::vector<WorkingRun>& work) {
  const double usual = usual_peak(work);
  for (std::size_t r = 0; r < work.size(); ++r) {
    WorkingRun& run = work[r];
    // One mighty blow in a file must not hide the ordinary ones.
    const double reference = std::min(run.hammer.peak, 3.0 * usual);
    run.level =
        options.trigger_percent
            ? 0.01 * *options.trigger_percent * run.hammer.peak
            : std::max(default_trigger * reference, 8.0 * run.hammer.noise);
    if (run.hammer.peak > usable_snr * run.hammer.noise) {
      run.pulses.pulses = find_pulses(run.hammer.force, run.level);
    }
    if (!run.pulses.pulses.empty()) continue;
    throw InputError(
        fmt::format("no hit was found: the hammer channel's largest value is "
                    "{:.3g} N over noise of {:.2g} N",
                    run.hammer.peak,
                    run.hammer.noise),
        bundle.runs[r].file.string(),
        "see whether the hammer's channel is named rightly, lower "
        "trigger_percent, or leave this run out");
  }
}

double usual_width(const std::vector<WorkingRun>& work) {
  std::vector<double> widths;
  for (const WorkingRun& run : work) {
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

// The longest that any response of any run's clearest hit lasts.
Index lasting_response(const TestBundle& bundle,
                       const std::vector<Recording>& recordings,
                       const std::vector<WorkingRun>& work) {
  Index lasting = 0;
  for (std::size_t r = 0; r < work.size(); ++r) {
    const PulseGroup& hit = clearest_hit(work[r].groups);
    for (const Placement& sensor : bundle.runs[r].sensors) {
      const Eigen::VectorXd channel =
          recordings[r].samples.col(static_cast<Index>(sensor.channel));
      const Eigen::VectorXd response =
          channel.segment(hit.first.first, hit.room).array() - median(channel);
      lasting = std::max(lasting, response_length(response));
    }
  }
  return lasting;
}

double band_end(const TestBundle& bundle, double rate) {
  return bundle.band_hz ? (*bundle.band_hz)[1] : 0.4 * rate;
}

Block block_for(const TestBundle& bundle,
                const std::vector<Recording>& recordings,
                const std::vector<WorkingRun>& work,
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
  for (const WorkingRun& run : work) groups.push_back(run.groups);
  return choose_block(groups, needs, options);
}

bool overloaded(const TestBundle& bundle,
                const Run& run,
                const Recording& recording,
                const Eigen::VectorXd& noise,
                Index begin,
                Index count) {
  std::vector<std::size_t> channels{run.hammer.channel};
  for (const Placement& sensor : run.sensors) {
    channels.push_back(sensor.channel);
  }
  return std::any_of(channels.begin(), channels.end(), [&](std::size_t c) {
    const auto column = static_cast<Index>(c);
    return is_overloaded(recording.samples.col(column).segment(begin, count),
                         std::abs(bundle.channels[c].full_scale_si()),
                         noise[column]);
  });
}

Eigen::VectorXd channel_noise(const Recording& recording) {
  Eigen::VectorXd noise(recording.samples.cols());
  for (Index c = 0; c < noise.size(); ++c) {
    noise[c] = difference_noise(recording.samples.col(c));
  }
  return noise;
}

// Everything that can be told from a hit alone.
std::vector<Hit> judge_alone(const TestBundle& bundle,
                             const Run& run,
                             const Recording& recording,
                             const WorkingRun& work,
                             const HitSet& set,
                             double double_percent) {
  const double rate = recording.sample_rate_hz;
  const Eigen::VectorXd noise = channel_noise(recording);
  std::vector<Hit> hits;
  for (const PulseGroup& group : work.groups) {
    Hit hit;
    const Index wanted = group.first.first - set.pre_trigger;
    const Index stop = wanted + set.block;
    hit.begin = std::max<Index>(0, wanted);
    hit.trigger = group.first.first;
    hit.time_s = static_cast<double>(group.largest.peak) / rate;
    hit.peak_n = group.largest.height;
    hit.pulse_s = group.largest.width / rate;
    const Index end = std::min(stop, recording.samples.rows());
    if (has_second_pulse(
            work.hammer, group.largest, hit.begin, end, double_percent)) {
      note(hit, HitFault::Double);
    }
    if (overloaded(bundle, run, recording, noise, hit.begin, end - hit.begin)) {
      note(hit, HitFault::Overload);
    }
    if (hit.peak_n < least_snr * work.hammer.noise) note(hit, HitFault::Weak);
    if (force_level_db(
            work.hammer, group.largest, band_end(bundle, rate), rate) <
        softest_db) {
      note(hit, HitFault::Soft);
    }
    if (wanted < 0 || stop > recording.samples.rows()) {
      note(hit, HitFault::Truncated);
    }
    hits.push_back(hit);
  }
  return hits;
}

void state_choices(const std::vector<WorkingRun>& work,
                   const Block& block,
                   const HitOptions& options,
                   HitSet& set) {
  double highest = 0.0;
  double peak = 0.0;
  bool negative = false;
  set.trigger_n = work[0].level;
  for (const WorkingRun& run : work) {
    set.trigger_n = std::min(set.trigger_n, run.level);
    highest = std::max(highest, run.level);
    peak = std::max(peak, run.hammer.peak);
    negative = negative || run.hammer.polarity < 0.0;
  }
  set.statements.push_back(fmt::format(
      "trigger at {:.3g} to {:.3g} N, {:.2g} % of each run's largest peak or "
      "8 times its noise (largest peak of all: {:.3g} N)",
      set.trigger_n,
      highest,
      options.trigger_percent.value_or(100.0 * default_trigger),
      peak));
  set.statements.push_back(
      fmt::format("block of {:.4g} s ({} samples), {}; pre-trigger {:.3g} s",
                  static_cast<double>(set.block) / set.sample_rate_hz,
                  set.block,
                  block.reason,
                  static_cast<double>(set.pre_trigger) / set.sample_rate_hz));
  if (negative) {
    set.statements.emplace_back(
        "blows are negative in the hammer channel of at least one run: is its "
        "polarity right?");
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
  HitOptions options = given;
  if (!options.trigger_percent) {
    options.trigger_percent = bundle.trigger_percent;
  }
  if (!options.pre_trigger_s) options.pre_trigger_s = bundle.pre_trigger_s;
  if (!options.block_s) options.block_s = bundle.block_s;

  std::vector<WorkingRun> work;
  prepare(bundle, recordings, work);
  trigger(bundle, options, work);
  std::vector<RunPulses> pulses;
  for (const WorkingRun& run : work) pulses.push_back(run.pulses);
  const double rate = recordings[0].sample_rate_hz;
  const Index hold_off = choose_hold_off(pulses, rate, options);
  for (WorkingRun& run : work) run.groups = group_pulses(run.pulses, hold_off);

  const Block block = block_for(bundle, recordings, work, options);
  HitSet set;
  set.sample_rate_hz = rate;
  set.block = block.samples;
  set.pre_trigger = block.pre_trigger;
  state_choices(work, block, options, set);
  for (std::size_t r = 0; r < work.size(); ++r) {
    std::vector<Hit> hits = judge_alone(bundle,
                                        bundle.runs[r],
                                        recordings[r],
                                        work[r],
                                        set,
                                        options.double_hit_percent);
    judge_weak(hits);
    judge_outliers(bundle.runs[r], recordings[r], work[r].hammer, set, hits);
    rescue(bundle.runs[r], work[r].hammer.noise, hits, set.statements);
    set.runs.push_back(std::move(hits));
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
