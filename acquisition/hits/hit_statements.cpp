#include "acquisition/hits/hit_statements.hpp"

#include "acquisition/hits/hit_warnings.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>

namespace tapfit::acquisition {
namespace {

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
    for (const Pulse& pulse : run.pulses.pulses) {
      peak = std::max(peak, pulse.height);
    }
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

void state_block(const HitOptions& options, HitSet& set) {
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
                  set.block_reason,
                  static_cast<double>(set.pre_trigger) / set.sample_rate_hz));
}

void state_reach(const TestBundle& bundle, HitSet& set) {
  if (set.usable_bandwidth_hz >= band_end(bundle, set.sample_rate_hz)) return;
  set.statements.push_back(fmt::format(
      "no band is given: hits are judged up to {:.3g} Hz, where the "
      "usual one's force has fallen by 10 dB; give band_hz",
      set.usable_bandwidth_hz));
}

}  // namespace

void state_choices(const TestBundle& bundle,
                   const std::vector<HammerRun>& runs,
                   const HitOptions& options,
                   HitSet& set) {
  state_trigger(bundle, runs, options, set);
  state_block(options, set);
  state_reach(bundle, set);
  for (Finding& warning : hit_warnings(bundle, runs, options, set)) {
    set.statements.push_back(in_full(warning));
    set.findings.push_back(std::move(warning));
  }
}

}  // namespace tapfit::acquisition
