#include "acquisition/judge_ceiling.hpp"

#include "acquisition/parallel.hpp"
#include "acquisition/runs_alike.hpp"

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
  double flattest = 0.0;
  bool shown = false;   ///< at one place most others are less flat
  bool denied = false;  ///< at one place they are as flat
};

// The hits of one placement, as a ceiling parts them.
struct Parted {
  std::vector<Hit*> cut;
  double flattest = 0.0;       ///< of the cut ones
  std::ptrdiff_t as_flat = 0;  ///< of the others
  std::ptrdiff_t less_flat = 0;
};

Parted parted(const RunGroup& group,
              const ForceCeiling& ceiling,
              const std::vector<std::vector<Topped>>& of_runs) {
  Parted hits;
  for (const std::size_t r : group) {
    for (const Topped& one : of_runs[r]) {
      if (is_cut(ceiling, one.top)) {
        hits.cut.push_back(one.hit);
        hits.flattest = std::max(hits.flattest, one.top.flatness);
      } else if (one.top.flatness >= ceiling.least_flatness) {
        ++hits.as_flat;
      } else {
        ++hits.less_flat;
      }
    }
  }
  return hits;
}

// Judges the cut hits of one placement, if enough others remain. Where these
// are as flat, it is the place's shape (what gives way there, and the tip).
void judge_placement(const RunGroup& group,
                     const ForceCeiling& ceiling,
                     const std::vector<std::vector<Topped>>& of_runs,
                     HitSet& set,
                     Cut& sum) {
  Parted hits = parted(group, ceiling, of_runs);
  if (hits.cut.empty()) return;
  sum.flattest = std::max(sum.flattest, hits.flattest);
  sum.all += hits.cut.size();
  const bool apart = hits.less_flat > hits.as_flat;
  sum.shown = sum.shown || apart;
  sum.denied = sum.denied || hits.as_flat > hits.less_flat;
  sum.known += std::erase_if(hits.cut, [](Hit* hit) { return !hit->accepted; });
  std::ptrdiff_t good = -std::ssize(hits.cut);
  for (const std::size_t r : group) {
    good += std::ranges::count_if(set.runs[r], &Hit::accepted);
  }
  if (ceiling.evidence == Evidence::Suspicion || good < 2 || !apart) return;
  for (Hit* hit : hits.cut) note(*hit, HitFault::Overload);
  sum.out += hits.cut.size();
  for (const std::size_t r : group) set.ceilings[r] = ceiling;
}

bool is_certain(const ForceCeiling& ceiling, const Cut& cut) {
  if (ceiling.evidence == Evidence::Suspicion) return false;
  return cut.shown || (ceiling.evidence == Evidence::Corners && !cut.denied);
}

std::string fate(const Cut& cut) {
  const std::size_t kept = cut.all - cut.out - cut.known;
  if (kept == 0) return "they are judged out";
  if (cut.out == 0) return "none is judged out for that";
  return fmt::format(
      "{} are judged out, {} kept for want of better ones at their points",
      cut.out,
      kept);
}

std::string statement(const ForceCeiling& ceiling,
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
      100.0 * lost_force(cut.flattest),
      fate(cut));
}

// All runs of one hammer channel.
void judge_channel(const std::vector<RunGroup>& groups,
                   const std::vector<std::vector<Topped>>& of_runs,
                   HitSet& set) {
  std::vector<PulseTop> tops;
  for (const RunGroup& group : groups) {
    for (const std::size_t r : group) {
      for (const Topped& one : of_runs[r]) tops.push_back(one.top);
    }
  }
  const std::optional<ForceCeiling> ceiling = find_ceiling(tops);
  if (!ceiling) return;
  Cut cut;
  for (const RunGroup& group : groups) {
    judge_placement(group, *ceiling, of_runs, set, cut);
  }
  // What the recorder itself has cut off is known, and nothing new.
  if (cut.all == cut.known) return;
  set.statements.push_back(statement(*ceiling, cut, tops.size()));
  set.warnings.push_back(set.statements.back());
}

}  // namespace

bool tells_height(const Hit& hit) {
  return std::ranges::none_of(hit.reasons, [](HitFault fault) {
    return fault == HitFault::Double || fault == HitFault::Weak;
  });
}

void judge_ceilings(const TestBundle& bundle,
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
    judge_channel(groups, of_runs, set);
  }
}

}  // namespace tapfit::acquisition
