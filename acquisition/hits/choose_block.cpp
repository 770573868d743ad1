#include "acquisition/hits/choose_block.hpp"

#include "acquisition/samples/statistics.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace tapfit::acquisition {
namespace {

using Eigen::Index;

// Beyond any record: as long as the longest one that has a number.
Index rounded(double samples) {
  constexpr double beyond = 1e15;
  return static_cast<Index>(std::llround(std::min(samples, beyond)));
}

// Samples kept free before the next hit: its onset and a filter's ringing.
Index guard(const BlockNeeds& needs) {
  return std::max<Index>(6, rounded(2.0 * needs.pulse_width));
}

std::vector<Index> rooms_of(const std::vector<PulseGroup>& run,
                            const BlockNeeds& needs) {
  std::vector<Index> rooms;
  for (const PulseGroup& group : run) {
    const Index room = group.ends_file ? group.room : group.room - guard(needs);
    rooms.push_back(std::max<Index>(0, room));
  }
  return rooms;
}

// The room after the trigger that all hits, or all but a few, have.
Index common_room(const std::vector<std::vector<PulseGroup>>& runs,
                  const BlockNeeds& needs) {
  std::vector<Index> all;
  Index every_run = std::numeric_limits<Index>::max();
  for (const std::vector<PulseGroup>& run : runs) {
    const std::vector<Index> rooms = rooms_of(run, needs);
    all.insert(all.end(), rooms.begin(), rooms.end());
    every_run =
        std::min(every_run, *std::max_element(rooms.begin(), rooms.end()));
  }
  std::sort(all.begin(), all.end());
  const double usual = static_cast<double>(all[all.size() / 5]);
  const auto kept = std::find_if(all.begin(), all.end(), [&](Index room) {
    return static_cast<double>(room) >= 0.6 * usual;
  });
  return std::min(*kept, every_run);
}

// Two per cent of the block, long enough for a baseline, and short enough for
// the first hit of every file unless that leaves next to nothing.
Index choose_pre_trigger(const std::vector<std::vector<PulseGroup>>& runs,
                         const BlockNeeds& needs,
                         const HitOptions& options,
                         Index room) {
  if (options.pre_trigger_s) {
    return rounded(*options.pre_trigger_s * needs.sample_rate_hz);
  }
  const Index least = std::max<Index>(2, rounded(needs.pulse_width));
  Index pre = std::max({room / 50, 4 * least, Index{16}});
  pre = std::max(least, std::min(pre, room / 4));
  for (const std::vector<PulseGroup>& run : runs) {
    const Index first = run.front().first.first;
    if (first >= least) pre = std::min(pre, first);
  }
  return pre;
}

// The length asked for, unless that would not hold the pre-trigger and a pulse.
void take_wish(double block_s, const BlockNeeds& needs, Block& block) {
  const Index wished = rounded(block_s * needs.sample_rate_hz);
  const Index least =
      block.pre_trigger + std::max<Index>(2, rounded(2.0 * needs.pulse_width));
  block.samples = std::max(wished, least);
  block.reason =
      wished >= least
          ? "as asked for"
          : fmt::format(
                "not the {:.4g} s asked for, which do not hold the pre-trigger "
                "and a pulse of {:.2g} s",
                block_s,
                needs.pulse_width / needs.sample_rate_hz);
}

/// What would do, were there room, and why.
struct Enough {
  Index samples = 0;
  std::string reason;
};

Enough enough_for(const BlockNeeds& needs) {
  Enough enough{needs.lasting + needs.lasting / 5,
                "as long as the response lasts"};
  if (needs.slowest) {
    // A tenth more, since the rate is estimated.
    const double seconds = 1.1 * decayed_time_constants / needs.slowest->rate;
    const Index samples = rounded(seconds * needs.sample_rate_hz);
    if (samples > enough.samples) {
      enough = {samples,
                fmt::format("as long as the response lasts ({:.2g} time "
                            "constants of {:.3g} s between {:.3g} and {:.3g} "
                            "Hz)",
                            1.1 * decayed_time_constants,
                            1.0 / needs.slowest->rate,
                            needs.slowest->octave_hz[0],
                            needs.slowest->octave_hz[1])};
    }
  }
  if (needs.least <= enough.samples) return enough;
  return {needs.least, "as long as the band's resolution needs"};
}

}  // namespace

Index choose_hold_off(const std::vector<RunPulses>& runs,
                      double sample_rate_hz,
                      const HitOptions& options) {
  if (options.trigger.hold_off_s) {
    return rounded(*options.trigger.hold_off_s * sample_rate_hz);
  }
  if (options.block_s) return rounded(*options.block_s * sample_rate_hz);
  const double deliberate = 0.5 * sample_rate_hz;
  std::vector<double> gaps;
  for (const RunPulses& run : runs) {
    const std::size_t before = gaps.size();
    for (std::size_t i = 1; i < run.pulses.size(); ++i) {
      const auto gap =
          static_cast<double>(run.pulses[i].first - run.pulses[i - 1].first);
      if (gap > deliberate) gaps.push_back(gap);
    }
    if (gaps.size() == before && !run.pulses.empty()) {
      gaps.push_back(
          static_cast<double>(run.samples - run.pulses.front().first));
    }
  }
  return std::max<Index>(1, rounded(0.2 * median(gaps)));
}

std::vector<PulseGroup> group_pulses(const RunPulses& run, Index hold_off) {
  std::vector<PulseGroup> groups;
  for (const Pulse& pulse : run.pulses) {
    if (!groups.empty() && pulse.first - groups.back().first.first < hold_off) {
      if (pulse.height > groups.back().largest.height) {
        groups.back().largest = pulse;
      }
      continue;
    }
    if (!groups.empty()) {
      groups.back().room = pulse.first - groups.back().first.first;
    }
    groups.push_back({.first = pulse, .largest = pulse});
  }
  if (!groups.empty()) {
    groups.back().room = run.samples - groups.back().first.first;
    groups.back().ends_file = true;
  }
  return groups;
}

Index smooth_length(Index n) {
  for (n -= n % 2; n > 2; n -= 2) {
    Index rest = n;
    for (const Index prime : {2, 3, 5, 7}) {
      while (rest % prime == 0) rest /= prime;
    }
    if (rest == 1) return n;
  }
  return 2;
}

Index response_length(const Eigen::VectorXd& response) {
  const Index window = std::max<Index>(8, response.size() / 64);
  const Index count = response.size() / window;
  if (count < 2) return response.size();
  Eigen::VectorXd rms(count);
  for (Index k = 0; k < count; ++k) {
    rms[k] = response.segment(k * window, window).norm();
  }
  const double floor = std::max(1.5 * rms.minCoeff(), 1e-3 * rms.maxCoeff());
  // Without 20 dB of decay the quietest window says nothing about the noise.
  if (floor > 0.1 * rms.maxCoeff()) return response.size();
  Index last = count - 1;
  while (last > 0 && rms[last] <= floor) --last;
  return (last + 1) * window;
}

Block choose_block(const std::vector<std::vector<PulseGroup>>& runs,
                   const BlockNeeds& needs,
                   const HitOptions& options) {
  const Index room = common_room(runs, needs);
  Block block;
  block.pre_trigger = choose_pre_trigger(runs, needs, options, room);
  if (options.block_s) {
    take_wish(*options.block_s, needs, block);
    return block;
  }
  const Enough enough = enough_for(needs);
  const bool fits = enough.samples < room;
  block.reason = fits
                     ? enough.reason
                     : "as long as the hits' spacing and the files' ends allow";
  block.samples =
      smooth_length((fits ? enough.samples : room) + block.pre_trigger);
  return block;
}

}  // namespace tapfit::acquisition
