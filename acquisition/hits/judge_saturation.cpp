#include "acquisition/hits/judge_saturation.hpp"

#include "acquisition/bundle/runs_alike.hpp"
#include "acquisition/foundation/parallel.hpp"
#include "acquisition/hits/saturated_tops.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <string>
#include <utility>

namespace tapfit::acquisition {
namespace {

/// A hit and the top of its pulse.
struct Topped {
  std::size_t run = 0;
  Hit* hit = nullptr;
  PulseTop top;
};

std::vector<std::vector<Topped>> topped_hits(const std::vector<HammerRun>& runs,
                                             HitSet& set) {
  std::vector<std::vector<Topped>> of_runs(runs.size());
  for_each_parallel(runs.size(), [&](std::size_t r) {
    const HammerSignal& hammer = runs[r].hammer;
    for (std::size_t k = 0; k < set.runs[r].size(); ++k) {
      Hit& hit = set.runs[r][k];
      if (!tells_height(hit)) continue;
      const Pulse& pulse = runs[r].groups[k].largest;
      of_runs[r].push_back(
          {r, &hit, measure_top(hammer.force, pulse, hammer.noise)});
    }
  });
  return of_runs;
}

// What becomes of the hits at a ceiling.
struct Cut {
  std::size_t all = 0;
  std::size_t out = 0;    ///< judged out now
  std::size_t known = 0;  ///< judged out before, whatever for
  double lost = 0.0;      ///< most of the force, relative
  bool shown = false;     ///< where others of the same points are less flat
};

std::vector<PulseTop> tops_of(const RunGroup& group,
                              const std::vector<std::vector<Topped>>& of_runs) {
  std::vector<PulseTop> tops;
  for (const std::size_t r : group) {
    for (const Topped& one : of_runs[r]) tops.push_back(one.top);
  }
  return tops;
}

// The flatness from which blows at these points are cut off; none where fewer
// than two of them are below the ceiling.
std::optional<double> own_flatness(
    const RunGroup& group,
    const HammerSaturation& ceiling,
    const std::vector<std::vector<Topped>>& of_runs) {
  const TopsByLevel tops =
      tops_by_level(tops_of(group, of_runs), ceiling.level_n);
  if (tops.below.size() < 2) return std::nullopt;
  return cut_flatness(tops.below);
}

// Where it is all cut off, the least flat tip may have been at work.
double least_flatness(const std::vector<RunGroup>& groups,
                      const HammerSaturation& ceiling,
                      const std::vector<std::vector<Topped>>& of_runs) {
  double least = ceiling.least_flatness;
  for (const RunGroup& group : groups) {
    least =
        std::min(least, own_flatness(group, ceiling, of_runs).value_or(least));
  }
  return least;
}

// What a cut takes from a tip that is flat without one: a half sine that is as
// flat has lost as much before.
double lost_beyond(double usual, double flatness) {
  return (1.0 + lost_force(flatness)) / (1.0 + lost_force(usual)) - 1.0;
}

// Judges the cut hits of one placement, if enough others remain. Tips and
// places have shapes of their own: hits are compared with those of the same
// points where there are two or more below the ceiling.
void judge_placement(const RunGroup& group,
                     HammerSaturation ceiling,
                     const std::vector<std::vector<Topped>>& of_runs,
                     HitSet& set,
                     Cut& sum) {
  const auto own = own_flatness(group, ceiling, of_runs);
  ceiling.least_flatness = own.value_or(ceiling.least_flatness);
  const double usual = ceiling.least_flatness - flatter;
  std::vector<Hit*> cut;
  for (const std::size_t r : group) {
    for (const Topped& one : of_runs[r]) {
      if (!is_cut(ceiling, one.top)) continue;
      ++sum.all;
      sum.shown = sum.shown || own.has_value();
      sum.lost = std::max(sum.lost, lost_beyond(usual, one.top.flatness));
      one.hit->accepted ? cut.push_back(one.hit) : void(++sum.known);
    }
  }
  std::ptrdiff_t good = -std::ssize(cut);
  for (const std::size_t r : group) {
    good += std::ranges::count_if(set.runs[r], &Hit::accepted);
  }
  if (ceiling.evidence == Evidence::Suspicion || good < 2) return;
  for (Hit* hit : cut) reject(*hit, HitFault::Overload);
  sum.out += cut.size();
  for (const std::size_t r : group) set.ceilings[r] = ceiling;
}

// Of all blows; else of those of one placement, which another one's tip hides.
std::optional<HammerSaturation> ceiling_of(
    const std::vector<RunGroup>& groups,
    const std::vector<std::vector<Topped>>& of_runs) {
  std::vector<PulseTop> tops;
  for (const RunGroup& group : groups) {
    for (const PulseTop& top : tops_of(group, of_runs)) tops.push_back(top);
  }
  const std::optional<HammerSaturation> of_all = find_saturation(tops);
  if (of_all && of_all->evidence != Evidence::Suspicion) return of_all;
  const double level = highest_level(tops);
  for (const RunGroup& group : groups) {
    const std::vector<PulseTop> own = tops_of(group, of_runs);
    std::optional<HammerSaturation> ceiling = find_saturation(own);
    // Where others go higher there is none.
    if (!ceiling || ceiling->evidence == Evidence::Suspicion ||
        tops_by_level(own, level).highest.empty()) {
      continue;
    }
    ceiling->level_n = level;
    ceiling->least_flatness = cut_flatness(tops_by_level(tops, level).below);
    return ceiling;
  }
  return of_all;
}

bool is_certain(const HammerSaturation& ceiling, const Cut& cut) {
  if (ceiling.evidence == Evidence::Suspicion) return false;
  return cut.shown || ceiling.evidence == Evidence::Corners;
}

std::string fate(const Cut& cut) {
  const std::size_t kept = cut.all - cut.out - cut.known;
  if (kept == 0) return "they are rejected";
  if (cut.out == 0) return "none is rejected for that";
  return fmt::format(
      "{} are rejected, {} kept for want of better ones at their points",
      cut.out,
      kept);
}

std::string statement(const HammerSaturation& ceiling,
                      const Cut& cut,
                      std::size_t hits) {
  const bool all = cut.all == hits;
  return fmt::format(
      "{} of {} hits {} flat at {:.3g} N, {}: the hammer's conditioner {} "
      "ahead of the recorder's filter. The force of such hits is too small and "
      "FRFs are too large, by up to some {:.0f} %; {}. Strike less hard, or "
      "turn the conditioner's gain down",
      cut.all,
      hits,
      cut.all == 1 ? "ends" : "end",
      ceiling.level_n,
      all ? "however steeply they rise" : "flatter than weaker ones",
      is_certain(ceiling, cut) ? "saturates" : "may saturate",
      100.0 * cut.lost,
      fate(cut));
}

// All runs of one hammer channel.
void judge_channel(const TestBundle& bundle,
                   std::size_t channel,
                   const std::vector<RunGroup>& groups,
                   const std::vector<std::vector<Topped>>& of_runs,
                   HitSet& set) {
  std::optional<HammerSaturation> ceiling = ceiling_of(groups, of_runs);
  if (!ceiling) return;
  ceiling->least_flatness = least_flatness(groups, *ceiling, of_runs);
  Cut cut;
  for (const RunGroup& group : groups) {
    judge_placement(group, *ceiling, of_runs, set, cut);
  }
  // What the recorder itself has cut off is known, and nothing new.
  if (cut.all == cut.known) return;
  std::size_t hits = 0;
  for (const RunGroup& group : groups) hits += tops_of(group, of_runs).size();
  set.statements.push_back(statement(*ceiling, cut, hits));
  Subject where;
  where.channel = bundle.channels[channel].name;
  set.findings.push_back(
      {Severity::Warning, std::move(where), set.statements.back(), {}, {}});
}

}  // namespace

bool tells_height(const Hit& hit) {
  return std::ranges::none_of(hit.reasons, [](HitFault fault) {
    return fault == HitFault::Double || fault == HitFault::Weak;
  });
}

void judge_saturation(const TestBundle& bundle,
                      const std::vector<HammerRun>& runs,
                      HitSet& set) {
  set.ceilings.assign(runs.size(), std::nullopt);
  const auto of_runs = topped_hits(runs, set);
  std::map<std::size_t, std::vector<RunGroup>> of_channels;
  for (RunGroup& group : runs_alike(bundle)) {
    const std::size_t channel = bundle.runs[group.front()].hammer.channel;
    of_channels[channel].push_back(std::move(group));
  }
  for (const auto& [channel, groups] : of_channels) {
    judge_channel(bundle, channel, groups, of_runs, set);
  }
}

}  // namespace tapfit::acquisition
