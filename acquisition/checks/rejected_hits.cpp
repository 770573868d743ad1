#include "acquisition/checks/rejected_hits.hpp"

#include "acquisition/checks/force_channel.hpp"
#include "acquisition/hits/hammer_pulses.hpp"
#include "acquisition/hits/judge_hits.hpp"
#include "acquisition/hits/overload.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <map>
#include <ranges>
#include <utility>

namespace tapfit::acquisition {
namespace {

using Eigen::Index;

bool has(const Hit& hit, HitFault fault) {
  return std::ranges::count(hit.reasons, fault) > 0;
}

// What judges a hit out: not a second blow that is noted and costs little.
std::vector<HitFault> faults_of(const Hit& hit) {
  std::vector<HitFault> faults = hit.reasons;
  if (hit.second && !hit.second->thins_force && !hit.second->leaves_block) {
    std::erase(faults, HitFault::Double);
  }
  return faults;
}

bool any_hit_accepted(const HitSet& hits) {
  return std::ranges::any_of(hits.runs, [](const std::vector<Hit>& run) {
    return std::ranges::any_of(run, &Hit::accepted);
  });
}

bool is_clipped(const TestBundle& bundle,
                const Recording& recording,
                std::size_t channel,
                const Hit& hit,
                Index block) {
  const auto x = recording.samples.col(static_cast<Index>(channel));
  const Index begin = std::clamp<Index>(hit.begin, 0, x.size());
  const Index count = std::min(block, x.size() - begin);
  return count > 0 &&
         is_overloaded(x.segment(begin, count),
                       std::abs(bundle.channels[channel].full_scale_si()),
                       difference_noise(x));
}

// Names of the channels that some overloaded hit of the run clips.
std::vector<std::string> clipped_channels(const TestBundle& bundle,
                                          std::size_t run,
                                          const Recording& recording,
                                          const HitSet& hits) {
  std::vector<std::size_t> channels{bundle.runs[run].hammer.channel};
  for (const Placement& sensor : bundle.runs[run].sensors) {
    channels.push_back(sensor.channel);
  }
  std::vector<std::string> names;
  for (const std::size_t channel : channels) {
    const bool any = std::ranges::any_of(hits.runs[run], [&](const Hit& hit) {
      return has(hit, HitFault::Overload) &&
             is_clipped(bundle, recording, channel, hit, hits.block);
    });
    if (any) names.push_back(bundle.channels[channel].name);
  }
  return names;
}

// What stops hits of that fault, and the way out.
std::pair<std::string, std::string> way_out(HitFault fault) {
  switch (fault) {
    case HitFault::Double:
      return {
          "the hammer struck twice, or the next blow lies inside the block: "
          "the block ends before the second response has decayed, or both "
          "blows cancel at lines of the band",
          "give a block_s (and hold_off_s) shorter than the time between "
          "blows; where the hammer bounces, accept the hits with the "
          "smallest second blow by hand (Space on the Recording screen)"};
    case HitFault::Overload:
      return {"the range was too small for these blows",
              "measure again with a wider range or lighter blows; where little "
              "is cut off, accept the weakest hit by hand"};
    case HitFault::Truncated:
      return {
          "the recording ends, or the next blow comes, before the block "
          "does",
          "give a block_s that fits between trigger and the file's end"};
    case HitFault::Soft:
      return {"the hammer's tip is too soft for the band",
              "lower the upper end of band_hz, or take a harder tip"};
    case HitFault::Weak:
      return {"what triggered is hardly more than noise",
              "raise trigger_percent, or hit harder"};
    case HitFault::Outlier:
      return {"hits that disagree with each other",
              "see which point and direction they were meant for"};
    case HitFault::ByHand:
      return {"they were rejected by hand", "accept them again (Space)"};
  }
  return {};
}

/// Runs whose hits are judged out for the same reasons.
struct Rejected {
  std::vector<std::size_t> runs;
  std::size_t hits = 0;
  std::map<HitFault, int> counts;
  std::string clipped;  ///< channels that overload

  [[nodiscard]] bool is_like(const Rejected& other) const {
    return clipped == other.clipped &&
           std::ranges::equal(std::views::keys(counts),
                              std::views::keys(other.counts));
  }
};

Rejected rejected_run(const TestBundle& bundle,
                      std::size_t run,
                      const Recording& recording,
                      const HitSet& hits) {
  Rejected found{{run}, hits.runs[run].size(), {}, {}};
  for (const Hit& hit : hits.runs[run]) {
    for (const HitFault fault : faults_of(hit)) ++found.counts[fault];
  }
  if (found.counts.contains(HitFault::Overload)) {
    found.clipped = fmt::format(
        "{}", fmt::join(clipped_channels(bundle, run, recording, hits), ", "));
  }
  return found;
}

Finding rejected_finding(const Rejected& rejected, Severity severity) {
  const auto most = std::ranges::max_element(
      rejected.counts, {}, [](const auto& entry) { return entry.second; });
  std::vector<std::string> reasons;
  for (const auto& [fault, count] : rejected.counts) {
    std::string words = fmt::format("{} {}", count, name(fault));
    if (fault == HitFault::Overload && !rejected.clipped.empty()) {
      words += " (" + rejected.clipped + ")";
    }
    reasons.push_back(std::move(words));
  }
  const auto [likely, remedy] = way_out(most->first);
  return {severity,
          {rejected.runs, {}, {}, {}},
          fmt::format("none of {} {} hits is accepted: {}",
                      rejected.runs.size() == 1 ? "its" : "their",
                      rejected.hits,
                      fmt::join(reasons, ", ")),
          likely,
          remedy};
}

}  // namespace

std::vector<Finding> rejected_hit_findings(
    const TestBundle& bundle,
    const std::vector<Recording>& recordings,
    const HitSet& hits) {
  const Severity severity =
      any_hit_accepted(hits) ? Severity::Warning : Severity::Error;
  std::vector<Rejected> all;
  for (std::size_t r = 0; r < hits.runs.size(); ++r) {
    const std::vector<Hit>& run = hits.runs[r];
    if (run.empty() || recordings[r].samples.rows() == 0) continue;
    const bool judged_out = std::ranges::all_of(run, [](const Hit& hit) {
      return !hit.accepted && !faults_of(hit).empty();
    });
    if (!judged_out) continue;
    Rejected here = rejected_run(bundle, r, recordings[r], hits);
    const auto like = std::ranges::find_if(
        all, [&here](const Rejected& other) { return here.is_like(other); });
    if (like == all.end()) {
      all.push_back(std::move(here));
      continue;
    }
    like->runs.push_back(r);
    like->hits += here.hits;
    for (const auto& [fault, count] : here.counts) like->counts[fault] += count;
  }
  std::vector<Finding> findings;
  for (const Rejected& one : all) {
    findings.push_back(rejected_finding(one, severity));
  }
  return findings;
}

InputError no_accepted_hit(const TestBundle& bundle,
                           const std::vector<Recording>& recordings,
                           const HitSet& hits) {
  // What explains them all stands first; runs that say the same say it once.
  std::vector<Finding> findings =
      force_channel_findings(bundle, recordings, hits);
  append(trigger_findings(bundle, recordings, hits), findings);
  const std::size_t causes = findings.size();
  append(hits.findings, findings);
  append(rejected_hit_findings(bundle, recordings, hits), findings);
  std::map<std::string, std::vector<std::size_t>> runs;
  std::vector<std::string> said;
  for (const Finding& finding : findings) {
    const std::string words = statement(finding);
    if (!runs.contains(words)) said.push_back(words);
    auto& of = runs[words];
    of.insert(of.end(), finding.where.runs.begin(), finding.where.runs.end());
  }
  std::string what = "no run has an accepted hit";
  for (const std::string& words : said) {
    const std::string where = describe({runs[words], {}, {}, {}});
    what += "; " + (where.empty() ? "" : where + ": ") + words;
  }
  const std::string remedy =
      findings.empty() ? "hit again"
                       : findings[causes > 0 ? 0 : findings.size() - 1].remedy;
  return {what, bundle.folder.string(), remedy};
}

std::vector<Finding> clipping_findings(const TestBundle& bundle,
                                       const std::vector<Recording>& recordings,
                                       const HitSet& hits) {
  std::vector<std::vector<std::size_t>> runs(bundle.channels.size());
  std::vector<int> clipped(bundle.channels.size());
  std::vector<int> all(bundle.channels.size());
  for (std::size_t r = 0; r < hits.runs.size(); ++r) {
    if (recordings[r].samples.rows() == 0) continue;
    std::vector<Placement> used = bundle.runs[r].sensors;
    used.push_back(bundle.runs[r].hammer);
    for (const Placement& place : used) {
      const std::size_t c = place.channel;
      int here = 0;
      for (const Hit& hit : hits.runs[r]) {
        ++all[c];
        here += has(hit, HitFault::Overload) &&
                        is_clipped(bundle, recordings[r], c, hit, hits.block)
                    ? 1
                    : 0;
      }
      clipped[c] += here;
      if (here > 0) runs[c].push_back(r);
    }
  }
  std::vector<Finding> findings;
  for (std::size_t c = 0; c < clipped.size(); ++c) {
    if (clipped[c] == 0 || 2 * clipped[c] < all[c]) continue;
    findings.push_back(
        {Severity::Error,
         {runs[c], bundle.channels[c].name, {}, {}},
         fmt::format("clipped in {} of {} hits", clipped[c], all[c]),
         "the range is too small for this signal",
         "measure again with a wider range or lighter blows"});
  }
  return findings;
}

std::vector<Finding> trigger_findings(const TestBundle& bundle,
                                      const std::vector<Recording>& recordings,
                                      const HitSet& hits) {
  // One sample in 2e4 of normal noise lies above 4 standard deviations.
  constexpr double within = 4.0;
  std::vector<std::size_t> runs;
  double level = 0.0;
  double largest = 0.0;
  for (std::size_t r = 0; r < hits.runs.size(); ++r) {
    if (hits.runs[r].empty() || recordings[r].samples.rows() == 0) continue;
    const HammerSignal hammer =
        prepare_hammer(recordings[r].samples.col(
                           static_cast<Index>(bundle.runs[r].hammer.channel)),
                       recordings[r].sample_rate_hz,
                       bundle.trigger.slope);
    const double asked = bundle.trigger_percent
                             ? 0.01 * *bundle.trigger_percent * hammer.peak
                             : hits.trigger_n;
    if (asked >= within * hammer.noise) continue;
    runs.push_back(r);
    if (hammer.noise > largest) {
      largest = hammer.noise;
      level = asked;
    }
  }
  if (runs.empty()) return {};
  return {
      {Severity::Error,
       {runs,
        bundle.channels[bundle.runs[runs.front()].hammer.channel].name,
        {},
        {}},
       fmt::format("the trigger at {:.2g} N lies within the noise of {:.2g} "
                   "N: noise counts as hits",
                   level,
                   largest),
       "trigger_percent (or trigger_range_percent) is too low",
       "leave it out of test.json, so that a level above the noise is "
       "chosen"}};
}

}  // namespace tapfit::acquisition
