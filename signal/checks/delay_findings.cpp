#include "signal/checks/delay_findings.hpp"

#include "acquisition/foundation/parallel.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <set>
#include <string>

namespace tapfit::signal {
namespace {

using acquisition::HitSet;
using acquisition::TestBundle;
using Eigen::Index;
using Eigen::VectorXd;

// Delays are looked for within so many samples: more is another blow's
// response, and what comes before the pulse is cut off.
constexpr double most_samples = 64.0;
// A first look that finds half of what is worth saying looks closer.
constexpr double first_look = 0.5;
// From there on samples were lost, not parts of them.
constexpr double whole_number = 0.05;
constexpr double whole_deviations = 3.0;
// Sensors agree on a step of the hammer's within that share of it.
constexpr double same_step = 0.2;
constexpr double same_deviations = 4.0;

/// One sensor's hits.
struct Sensor {
  HitDelays delays;
  DelayHistory history;
};

/// A step that one or all sensors show.
struct Told {
  DelayStep step;
  std::size_t channel = 0;
  bool hammer = false;
};

VectorXd times_of(const HitSet& hits, const GroupSpectra& of) {
  VectorXd times(static_cast<Index>(of.hits.size()));
  for (std::size_t k = 0; k < of.hits.size(); ++k) {
    const auto& [run, hit] = of.hits[k];
    if (run != of.hits.front().run) return {};
    times(static_cast<Index>(k)) = hits.runs[run][hit].time_s;
  }
  return times;
}

std::vector<Sensor> sensors_of(const HitSet& hits,
                               const GroupSpectra& of,
                               const DelayStepLimits& limits) {
  const double sample_s = 1.0 / hits.sample_rate_hz;
  const VectorXd times = times_of(hits, of);
  HitDelayOptions options;
  options.most_s =
      sample_s * std::min(most_samples, static_cast<double>(hits.block) / 8.0);
  options.slight_s = first_look * limits.worth_saying * sample_s;
  std::vector<Sensor> sensors(of.channels.size());
  for_each_parallel(sensors.size(), [&](std::size_t c) {
    sensors[c].delays = hit_delays(hit_frfs(of, c), options);
    sensors[c].history =
        delay_history(sensors[c].delays, times, sample_s, limits);
  });
  return sensors;
}

// Whether a sensor would have shown a step of that size.
bool able(const Sensor& sensor, double size_s, const DelayStepLimits& limits) {
  const VectorXd& sd = sensor.delays.sd_s;
  return sd.size() == 0 || limits.significance * sd.mean() < size_s;
}

// One step for all sensors where they agree: the hammer's.
std::optional<DelayStep> shared_step(
    const std::vector<Sensor>& sensors,
    const std::map<std::size_t, DelayStep>& steps,
    const DelayStepLimits& limits) {
  if (steps.size() < 2) return {};
  DelayStep sum = steps.begin()->second;
  double weights = 0.0;
  double weighted = 0.0;
  for (const auto& [sensor, step] : steps) {
    const double weight = 1.0 / (step.sd_s * step.sd_s);
    weights += weight;
    weighted += weight * step.delay_s;
  }
  sum.delay_s = weighted / weights;
  sum.sd_s = 1.0 / std::sqrt(weights);
  const double size = std::abs(sum.delay_s);
  for (const auto& [sensor, step] : steps) {
    const double off = std::abs(step.delay_s - sum.delay_s);
    if (off > std::max(same_step * size, same_deviations * step.sd_s)) {
      return {};
    }
  }
  for (std::size_t c = 0; c < sensors.size(); ++c) {
    if (!steps.contains(c) && able(sensors[c], size, limits)) return {};
  }
  sum.delay_s = -sum.delay_s;
  return sum;
}

// Steps at the same hit together; each a finding of its own.
std::vector<Told> told(const std::vector<Sensor>& sensors,
                       const std::map<std::size_t, DelayStep>& steps,
                       const GroupSpectra& of,
                       const DelayStepLimits& limits) {
  if (const auto all = shared_step(sensors, steps, limits)) {
    return {{*all, 0, true}};
  }
  std::vector<Told> each;
  for (const auto& [sensor, step] : steps) {
    each.push_back({step, of.channels[sensor], false});
  }
  return each;
}

// Hits [begin, end) of the group: "hits 4 to 7 of run 2, run 3".
std::string listed(const HitSet& hits,
                   const GroupSpectra& of,
                   Index begin,
                   Index end) {
  std::map<std::size_t, std::vector<std::size_t>> by_run;
  for (Index k = begin; k < end; ++k) {
    const HitAt& at = of.hits[static_cast<std::size_t>(k)];
    by_run[at.run].push_back(at.hit + 1);
  }
  std::vector<std::string> parts;
  for (const auto& [run, of_run] : by_run) {
    const auto accepted = static_cast<std::size_t>(
        std::ranges::count_if(hits.runs[run], &acquisition::Hit::accepted));
    if (of_run.size() == accepted) {
      parts.push_back(fmt::format("run {}", run + 1));
    } else if (of_run.size() == 1) {
      parts.push_back(fmt::format("hit {} of run {}", of_run[0], run + 1));
    } else {
      parts.push_back(fmt::format(
          "hits {} to {} of run {}", of_run.front(), of_run.back(), run + 1));
    }
  }
  return fmt::format("{}", fmt::join(parts, ", "));
}

struct Part {
  Index begin = 0;
  Index end = 0;
};

// The fewer of the hits on both sides.
Part fewer(const DelayStep& step) {
  if (step.first - step.begin < step.end - step.first) {
    return {step.begin, step.first};
  }
  return {step.first, step.end};
}

std::string size_of(const DelayStep& step, double rate) {
  const double samples = rate * std::abs(step.delay_s);
  return fmt::format("{:.3g} sample{} ({:.3g} ms, sd {:.1g})",
                     samples,
                     std::abs(samples - 1.0) < 5e-3 ? "" : "s",
                     1e3 * std::abs(step.delay_s),
                     1e3 * step.sd_s);
}

std::string cause_of_step(const Told& one, double rate, bool alone) {
  const double samples = rate * std::abs(one.step.delay_s);
  const double off = std::abs(samples - std::round(samples));
  const double limit =
      std::max(whole_number, whole_deviations * rate * one.step.sd_s);
  std::string cause;
  if (samples > 0.5 && off < limit) {
    cause = one.step.delay_s < 0.0
                ? "samples of this channel were lost between the two hits"
                : "samples of this channel were doubled between the two hits, "
                  "or those of the others were lost";
  } else {
    cause =
        "it was recorded by another clock or converter, which slipped between "
        "the two hits";
  }
  if (alone) cause += "; with one sensor it may as well be the hammer's";
  return cause;
}

Finding step_finding(const TestBundle& bundle,
                     const HitSet& hits,
                     const GroupSpectra& of,
                     const Told& one) {
  const HitAt& at = of.hits[static_cast<std::size_t>(one.step.first)];
  const std::size_t channel =
      one.hammer ? bundle.runs[at.run].hammer.channel : one.channel;
  const Part part = fewer(one.step);
  return {Severity::Warning,
          {{at.run}, bundle.channels.at(channel).name, at.hit, {}},
          fmt::format("from hit {} of run {} on it comes {} {} against {} than "
                      "in the hits before",
                      at.hit + 1,
                      at.run + 1,
                      size_of(one.step, hits.sample_rate_hz),
                      one.step.delay_s > 0.0 ? "later" : "earlier",
                      one.hammer ? "all sensors" : "the hammer"),
          cause_of_step(one, hits.sample_rate_hz, of.channels.size() == 1),
          fmt::format("leave {} out (Space on the Recording screen), or "
                      "measure it again: an average over both has too little "
                      "at its high end",
                      listed(hits, of, part.begin, part.end))};
}

Finding drift_finding(const TestBundle& bundle,
                      const HitSet& hits,
                      const GroupSpectra& of,
                      const Told& one) {
  const std::size_t run = of.hits.front().run;
  const std::size_t channel =
      one.hammer ? bundle.runs[run].hammer.channel : one.channel;
  return {Severity::Warning,
          {{run}, bundle.channels.at(channel).name, {}, {}},
          fmt::format("its delay against {} grows evenly from hit {} to hit {} "
                      "of run {}, by {} {}",
                      one.hammer ? "all sensors" : "the hammer",
                      of.hits.front().hit + 1,
                      of.hits.back().hit + 1,
                      run + 1,
                      size_of(one.step, hits.sample_rate_hz),
                      one.step.delay_s > 0.0 ? "later" : "earlier"),
          "it was recorded by a clock of its own, which runs faster or slower",
          "record all channels by one clock; until then give each hit a run "
          "of its own, or use the first hits only"};
}

class Changes {
 public:
  Changes(const TestBundle& bundle,
          const HitSet& hits,
          const GroupSpectra& of,
          const DelayStepLimits& limits)
      : bundle_(bundle),
        hits_(hits),
        of_(of),
        sensors_(sensors_of(hits, of, limits)),
        limits_(limits) {}

  [[nodiscard]] DelayChanges all() {
    add_drifts();
    add_steps();
    result_.hits.assign(odd_.begin(), odd_.end());
    return std::move(result_);
  }

 private:
  void add_drifts() {
    std::map<std::size_t, DelayStep> drifts;
    for (std::size_t c = 0; c < sensors_.size(); ++c) {
      if (sensors_[c].history.drift) drifts[c] = *sensors_[c].history.drift;
    }
    for (const Told& one : told(sensors_, drifts, of_, limits_)) {
      result_.findings.push_back(drift_finding(bundle_, hits_, of_, one));
      odd_.insert(of_.hits.begin(), of_.hits.end());
    }
  }

  void add_steps() {
    std::map<Index, std::map<std::size_t, DelayStep>> by_hit;
    for (std::size_t c = 0; c < sensors_.size(); ++c) {
      for (const DelayStep& step : sensors_[c].history.steps) {
        by_hit[step.first][c] = step;
      }
    }
    for (const auto& [first, steps] : by_hit) {
      for (const Told& one : told(sensors_, steps, of_, limits_)) {
        result_.findings.push_back(step_finding(bundle_, hits_, of_, one));
        const Part part = fewer(one.step);
        for (Index k = part.begin; k < part.end; ++k) {
          odd_.insert(of_.hits[static_cast<std::size_t>(k)]);
        }
      }
    }
  }

  const TestBundle& bundle_;
  const HitSet& hits_;
  const GroupSpectra& of_;
  std::vector<Sensor> sensors_;
  const DelayStepLimits& limits_;
  std::set<HitAt> odd_;
  DelayChanges result_;
};

}  // namespace

DelayChanges delay_changes(const TestBundle& bundle,
                           const HitSet& hits,
                           const GroupSpectra& of,
                           const DelayStepLimits& limits) {
  if (of.hits.size() < 2) return {};
  return Changes(bundle, hits, of, limits).all();
}

}  // namespace tapfit::signal
