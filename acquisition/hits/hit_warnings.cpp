#include "acquisition/hits/hit_warnings.hpp"

#include "acquisition/hits/undersampled_pulses.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <limits>

namespace tapfit::acquisition {
namespace {

using Eigen::Index;

std::string polarity(const std::vector<HammerRun>& runs,
                     const HitOptions& options) {
  const bool negative = std::ranges::any_of(
      runs, [](const HammerRun& run) { return run.hammer.polarity < 0.0; });
  if (!negative || options.trigger.slope) return {};
  return "blows are negative in the hammer channel of at least one run: is its "
         "polarity right? If not, FRFs have the wrong sign (a negative "
         "sensitivity turns the channel)";
}

// The side that is asked for must not be that of the smaller peaks.
std::string slope(const TestBundle& bundle,
                  const std::vector<HammerRun>& runs,
                  const HitOptions& options) {
  if (!options.trigger.slope) return {};
  for (std::size_t r = 0; r < runs.size(); ++r) {
    const Range all = joined(runs[r].hammer.pieces);
    if (-all.low < 1.5 * all.high) continue;
    const bool falling = *options.trigger.slope < 0;
    return fmt::format(
        "trigger_slope is \"{}\", but in {} the hammer's channel reaches "
        "{:.3g} "
        "N the other way and {:.3g} N this way: hits may be what follows a "
        "blow. Leave trigger_slope out, or turn it",
        falling ? "falling" : "rising",
        bundle.runs[r].file.filename().string(),
        -all.low,
        all.high);
  }
  return {};
}

std::string pre_trigger(const std::vector<HammerRun>& runs,
                        const HitOptions& options,
                        const HitSet& set) {
  const double least = std::max(2.0, usual_width(runs));  // as chosen without
  if (!options.pre_trigger_s ||
      static_cast<double>(set.pre_trigger) + 0.5 >= least) {
    return {};
  }
  return fmt::format(
      "pre_trigger_s of {:.3g} s is shorter than a pulse: blocks begin within "
      "the blow's rise and lose force. Give {:.2g} s or more, or leave it out",
      *options.pre_trigger_s,
      4.0 * least / set.sample_rate_hz);
}

// Hits as they would be grouped had no block been asked for, and which of them
// have the next one in the block.
std::string block(const std::vector<HammerRun>& runs,
                  const HitOptions& options,
                  const HitSet& set) {
  if (!options.block_s) return {};
  HitOptions without = options;
  without.block_s.reset();
  std::vector<RunPulses> pulses;
  for (const HammerRun& run : runs) pulses.push_back(run.pulses);
  const Index hold_off = choose_hold_off(pulses, set.sample_rate_hz, without);
  std::size_t all = 0;
  std::size_t crowded = 0;
  Index least = std::numeric_limits<Index>::max();
  for (const RunPulses& run : pulses) {
    for (const PulseGroup& group : group_pulses(run, hold_off)) {
      ++all;
      if (group.ends_file || group.room + set.pre_trigger >= set.block)
        continue;
      ++crowded;
      least = std::min(least, group.room);
    }
  }
  if (crowded == 0) return {};
  return fmt::format(
      "block_s of {:.4g} s is longer than the time to the next blow of {} of "
      "{} "
      "hits ({:.3g} s at the least): both lie in one block, which counts as a "
      "double hit. Give a shorter block_s, or leave it out",
      *options.block_s,
      crowded,
      all,
      static_cast<double>(least) / set.sample_rate_hz);
}

}  // namespace

std::vector<std::string> hit_warnings(const TestBundle& bundle,
                                      const std::vector<HammerRun>& runs,
                                      const HitOptions& options,
                                      const HitSet& set) {
  std::vector<std::string> warnings = {
      polarity(runs, options),
      slope(bundle, runs, options),
      pre_trigger(runs, options, set),
      block(runs, options, set),
      undersampled_statement(runs, set.sample_rate_hz)};
  std::erase(warnings, "");
  return warnings;
}

}  // namespace tapfit::acquisition
