#include "acquisition/hits/hit_warnings.hpp"

#include "acquisition/hits/undersampled_pulses.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <limits>
#include <optional>
#include <utility>

namespace tapfit::acquisition {
namespace {

using Eigen::Index;

using Warning = std::optional<Finding>;

Finding warning_of(Subject where,
                   std::string what,
                   std::string likely,
                   std::string remedy) {
  return {Severity::Warning,
          std::move(where),
          std::move(what),
          std::move(likely),
          std::move(remedy)};
}

Subject hammer_in(const TestBundle& bundle, std::vector<std::size_t> runs) {
  const std::size_t first = runs.empty() ? 0 : runs.front();
  return {std::move(runs),
          bundle.channels[bundle.runs[first].hammer.channel].name,
          {},
          {}};
}

Warning polarity(const TestBundle& bundle,
                 const std::vector<HammerRun>& runs,
                 const HitOptions& options) {
  if (options.trigger.slope) return {};
  std::vector<std::size_t> negative;
  for (std::size_t r = 0; r < runs.size(); ++r) {
    if (runs[r].hammer.polarity < 0.0) negative.push_back(r);
  }
  if (negative.empty()) return {};
  return warning_of(hammer_in(bundle, std::move(negative)),
                    "blows are negative in the hammer channel of at least one "
                    "run",
                    "its polarity is turned, and FRFs have the wrong sign",
                    "make the sensitivity of the hammer negative, or say "
                    "\"trigger_slope\": \"falling\" where it is right");
}

// The side that is asked for must not be that of the smaller peaks.
Warning slope(const TestBundle& bundle,
              const std::vector<HammerRun>& runs,
              const HitOptions& options) {
  if (!options.trigger.slope) return {};
  for (std::size_t r = 0; r < runs.size(); ++r) {
    const Range all = joined(runs[r].hammer.pieces);
    if (-all.low < 1.5 * all.high) continue;
    return warning_of(
        hammer_in(bundle, {r}),
        fmt::format("trigger_slope is \"{}\", but in {} the hammer's channel "
                    "reaches {:.3g} N the other way and {:.3g} N this way",
                    *options.trigger.slope < 0 ? "falling" : "rising",
                    bundle.runs[r].file.filename().string(),
                    -all.low,
                    all.high),
        "hits may be what follows a blow",
        "leave trigger_slope out, or turn it");
  }
  return {};
}

Warning pre_trigger(const TestBundle& bundle,
                    const std::vector<HammerRun>& runs,
                    const HitOptions& options,
                    const HitSet& set) {
  const double least = std::max(2.0, usual_width(runs));  // as chosen without
  if (!options.pre_trigger_s ||
      static_cast<double>(set.pre_trigger) + 0.5 >= least) {
    return {};
  }
  return warning_of(
      hammer_in(bundle, {}),
      fmt::format("pre_trigger_s of {:.3g} s is shorter than a pulse",
                  *options.pre_trigger_s),
      "blocks begin within the blow's rise and lose force",
      fmt::format("give {:.2g} s or more, or leave it out",
                  4.0 * least / set.sample_rate_hz));
}

// Hits as they would be grouped had no block been asked for, and which of them
// have the next one in the block.
Warning block(const TestBundle& bundle,
              const std::vector<HammerRun>& runs,
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
  return warning_of(
      hammer_in(bundle, {}),
      fmt::format("block_s of {:.4g} s is longer than the time to the next "
                  "blow of {} of {} hits ({:.3g} s at the least)",
                  *options.block_s,
                  crowded,
                  all,
                  static_cast<double>(least) / set.sample_rate_hz),
      "both lie in one block, which counts as a double hit",
      "give a shorter block_s, or leave it out");
}

Warning undersampled(const TestBundle& bundle,
                     const std::vector<HammerRun>& runs,
                     double rate) {
  std::string what = undersampled_statement(runs, rate);
  if (what.empty()) return {};
  return warning_of(hammer_in(bundle, {}), std::move(what), {}, {});
}

}  // namespace

std::vector<Finding> hit_warnings(const TestBundle& bundle,
                                  const std::vector<HammerRun>& runs,
                                  const HitOptions& options,
                                  const HitSet& set) {
  std::vector<Finding> warnings;
  std::array<Warning, 5> all{polarity(bundle, runs, options),
                             slope(bundle, runs, options),
                             pre_trigger(bundle, runs, options, set),
                             block(bundle, runs, options, set),
                             undersampled(bundle, runs, set.sample_rate_hz)};
  for (Warning& warning : all) {
    if (warning) warnings.push_back(std::move(*warning));
  }
  return warnings;
}

}  // namespace tapfit::acquisition
