#include "acquisition/hits/hit_steps.hpp"

#include "acquisition/foundation/parallel.hpp"
#include "acquisition/hits/double_hits.hpp"
#include "acquisition/hits/judge_hits.hpp"
#include "acquisition/hits/overload.hpp"
#include "acquisition/hits/second_pulses.hpp"
#include "acquisition/samples/statistics.hpp"

#include <algorithm>
#include <cmath>

namespace tapfit::acquisition {
namespace {

using Eigen::Index;

constexpr double least_snr = 20.0;    // peak over noise of a good hit
constexpr double softest_db = -20.0;  // at the band's end (ISO 7626-5)
// Of the main pulse: a force sensor is linear to no less.
constexpr double least_second = 0.005;
// Widths of blows that one hand strikes with one tip scatter by 8 %, and where
// nobody gave a band none of them is soft.
constexpr double scatters = 0.9;

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
  for_each_parallel(static_cast<std::size_t>(noise.size()), [&](std::size_t c) {
    const auto column = static_cast<Index>(c);
    noise[column] = difference_noise(recording.samples.col(column));
  });
  return noise;
}

// A hit as measured, not judged yet.
Hit hit_of(const PulseGroup& group, const HitSet& set, double rate) {
  Hit hit;
  hit.begin = std::max<Index>(0, group.first.first - set.pre_trigger);
  hit.trigger = group.first.first;
  hit.time_s = static_cast<double>(group.largest.peak) / rate;
  hit.peak_n = group.largest.height;
  hit.pulse_s = group.largest.width / rate;
  return hit;
}

// All blows of the block belong to its force; whether that makes it a bad hit
// depends on what it costs.
void judge_double(const HammerSignal& hammer,
                  const Pulse& main,
                  const JudgedBlock& block,
                  double double_percent,
                  Hit& hit) {
  std::vector<Pulse> pulses =
      second_pulses(hammer, main, hit.begin, block.end, least_second);
  hit.second = judge_second_pulses(hammer, main, pulses, block);
  if (!hit.second) return;
  pulses.push_back(main);
  for (const Pulse& pulse : pulses) {
    const auto reach = static_cast<Index>(std::ceil(pulse.width));
    hit.blows_before =
        std::max(hit.blows_before, hit.trigger - pulse.peak + reach);
    hit.blows_after =
        std::max(hit.blows_after, pulse.peak + reach - hit.trigger);
  }
  // The height of a pulse a few samples wide is known to a tenth.
  if (hit.second->share < 0.009 * double_percent) return;
  note(hit, HitFault::Double);
  if (hit.second->thins_force || hit.second->leaves_block) {
    reject(hit, HitFault::Double);
  }
}

}  // namespace

double rearm_share(const HitOptions& options) {
  return 0.01 * options.trigger.rearm_percent.value_or(50.0);
}

HammerRun prepare_run(const Run& run,
                      const Recording& recording,
                      std::optional<int> slope) {
  const auto channel = static_cast<Index>(run.hammer.channel);
  HammerRun result;
  result.hammer = prepare_hammer(
      recording.samples.col(channel), recording.sample_rate_hz, slope);
  result.pulses.samples = recording.samples.rows();
  return result;
}

double usual_width(const std::vector<HammerRun>& runs) {
  std::vector<double> widths;
  for (const HammerRun& run : runs) {
    for (const Pulse& pulse : run.pulses.pulses) widths.push_back(pulse.width);
  }
  return median(widths);
}

double band_end(const TestBundle& bundle, double rate) {
  return bundle.band_hz ? (*bundle.band_hz)[1] : 0.4 * rate;
}

double usable_bandwidth(const TestBundle& bundle,
                        const std::vector<HammerRun>& runs,
                        double rate) {
  const double most = band_end(bundle, rate);
  if (bundle.band_hz) return most;
  std::vector<double> reach;
  for (const HammerRun& run : runs) {
    // A few tell what is usual.
    constexpr std::size_t enough = 16;
    const std::size_t count = std::min(run.groups.size(), enough);
    for (std::size_t k = 0; k < count; ++k) {
      const Pulse& pulse = run.groups[k * run.groups.size() / count].largest;
      reach.push_back(
          force_reach_hz(run.hammer, pulse, 0.5 * softest_db, most, rate));
    }
  }
  return median(Eigen::VectorXd::Map(reach.data(), std::ssize(reach)));
}

std::vector<Hit> judge_alone(const TestBundle& bundle,
                             const Run& run,
                             const Recording& recording,
                             const HammerRun& work,
                             const HitSet& set,
                             double double_percent) {
  const double rate = recording.sample_rate_hz;
  const Eigen::VectorXd noise = channel_noise(recording);
  const double reach_hz = bundle.band_hz ? set.usable_bandwidth_hz
                                         : scatters * set.usable_bandwidth_hz;
  const double low_hz = bundle.band_hz ? (*bundle.band_hz)[0] : 0.0;
  std::vector<Hit> hits(work.groups.size());
  for_each_parallel(hits.size(), [&](std::size_t k) {
    const PulseGroup& group = work.groups[k];
    Hit& hit = hits[k] = hit_of(group, set, rate);
    const Index wanted = group.first.first - set.pre_trigger;
    const Index stop = wanted + set.block;
    const Index end = std::min(stop, recording.samples.rows());
    judge_double(work.hammer,
                 group.largest,
                 {end, rate, {low_hz, reach_hz}, set.decay},
                 double_percent,
                 hit);
    if (overloaded(bundle, run, recording, noise, hit.begin, end - hit.begin)) {
      reject(hit, HitFault::Overload);
    }
    if (hit.peak_n < least_snr * work.hammer.noise) reject(hit, HitFault::Weak);
    if (force_reach_hz(work.hammer, group.largest, softest_db, reach_hz, rate) <
        reach_hz) {
      reject(hit, HitFault::Soft);
    }
    if (wanted < 0 || stop > recording.samples.rows()) {
      reject(hit, HitFault::Truncated);
    }
  });
  return hits;
}

}  // namespace tapfit::acquisition
