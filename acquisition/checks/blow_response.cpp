#include "acquisition/checks/blow_response.hpp"

#include "acquisition/foundation/parallel.hpp"
#include "acquisition/samples/statistics.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace tapfit::acquisition {
namespace {

using Eigen::Index;
using Eigen::VectorXd;

constexpr Index shortest_window = 16;

struct Windows {
  Index before = 0;  // first samples
  Index after = 0;
  Index length = 0;
};

Windows windows_of(const HitSet& hits,
                   const std::vector<Hit>& all,
                   std::size_t k,
                   Index samples) {
  const auto pulse =
      static_cast<Index>(std::ceil(2.0 * all[k].pulse_s * hits.sample_rate_hz));
  const Index first = k > 0 ? (all[k - 1].trigger + all[k].trigger) / 2 : 0;
  const Index last =
      k + 1 < all.size() ? (all[k].trigger + all[k + 1].trigger) / 2 : samples;
  Windows windows;
  const Index end_before = all[k].trigger - pulse;
  windows.after = all[k].trigger + 2 * pulse;
  windows.length =
      std::min({hits.block / 4, end_before - first, last - windows.after});
  windows.before = end_before - windows.length;
  return windows;
}

// About the window's own line: what drifts is no noise.
double power(const Eigen::Ref<const VectorXd>& x) {
  const VectorXd t = VectorXd::LinSpaced(x.size(), -1.0, 1.0);  // of mean zero
  const double slope = t.dot(x) / t.squaredNorm();
  return (x.array() - x.mean() - slope * t.array()).square().mean();
}

std::vector<BlowResponse> responses_in(const TestBundle& bundle,
                                       std::size_t run,
                                       const Recording& recording,
                                       const HitSet& hits) {
  std::vector<BlowResponse> found;
  for (const Placement& sensor : bundle.runs[run].sensors) {
    const auto x = recording.samples.col(static_cast<Index>(sensor.channel));
    for (std::size_t k = 0; k < hits.runs[run].size(); ++k) {
      const Windows w = windows_of(hits, hits.runs[run], k, x.size());
      if (w.length < shortest_window || w.before < 0) continue;
      const double before = power(x.segment(w.before, w.length));
      const double after = power(x.segment(w.after, w.length));
      constexpr double tiny = std::numeric_limits<double>::min();
      found.push_back(
          {run, sensor.channel, k, (after + tiny) / (before + tiny)});
    }
  }
  return found;
}

// 1 where there are none.
double median_gain(const std::vector<const BlowResponse*>& responses) {
  if (responses.empty()) return 1.0;
  VectorXd gains(static_cast<Index>(responses.size()));
  for (Index i = 0; i < gains.size(); ++i) {
    gains(i) = responses[static_cast<std::size_t>(i)]->gain;
  }
  return median(gains);
}

template <class Wanted>
std::vector<const BlowResponse*> those(
    const std::vector<BlowResponse>& responses, const Wanted& wanted) {
  std::vector<const BlowResponse*> found;
  for (const BlowResponse& response : responses) {
    if (wanted(response)) found.push_back(&response);
  }
  return found;
}

// What a channel should hear of a run's blows: as much more than usual as the
// other channels do. One that hears no other blows either should as they do.
double expected_gain(const std::vector<BlowResponse>& responses,
                     std::size_t run,
                     std::size_t channel,
                     double heard) {
  const auto gain = [&](bool of_run, bool of_channel) {
    return median_gain(those(responses, [&](const BlowResponse& b) {
      return (b.run == run) == of_run && (b.channel == channel) == of_channel;
    }));
  };
  const double others = gain(true, false);
  const double elsewhere = gain(false, true);
  return elsewhere > heard ? others * elsewhere / gain(false, false) : others;
}

bool is_backwards(const std::vector<const BlowResponse*>& responses,
                  const BlowResponseLimits& limits) {
  if (responses.size() < 2 || median_gain(responses) > limits.backwards) {
    return false;
  }
  const auto louder_before = std::ranges::count_if(
      responses, [](const BlowResponse* r) { return r->gain < 1.0; });
  return static_cast<double>(louder_before) >=
         limits.backwards_share * static_cast<double>(responses.size());
}

Finding backwards_finding(std::vector<std::size_t> runs, double gain) {
  return {Severity::Error,
          {std::move(runs), {}, {}, {}},
          fmt::format("the response is {:.0f} dB louder before the blows than "
                      "after them",
                      -10.0 * std::log10(gain)),
          "the time axis runs backwards",
          "write the samples of these files in the order in which they were "
          "measured"};
}

Finding silent_finding(const std::string& channel,
                       std::vector<std::size_t> runs,
                       double gain) {
  return {Severity::Error,
          {std::move(runs), channel, {}, {}},
          fmt::format("the channel is as loud before the blows as after them "
                      "({:+.1f} dB), and another hears them",
                      10.0 * std::log10(gain)),
          "noise only: a cable that is off, a sensor without supply, or one at "
          "a place that does not move",
          "take the channel out of `sensors` of these runs, or measure again"};
}

}  // namespace

std::vector<BlowResponse> blow_responses(
    const TestBundle& bundle,
    const std::vector<Recording>& recordings,
    const HitSet& hits) {
  std::vector<std::vector<BlowResponse>> of(recordings.size());
  for_each_parallel(std::min(of.size(), hits.runs.size()), [&](std::size_t r) {
    if (recordings[r].samples.rows() == 0) return;
    of[r] = responses_in(bundle, r, recordings[r], hits);
  });
  std::vector<BlowResponse> all;
  for (const auto& found : of)
    all.insert(all.end(), found.begin(), found.end());
  return all;
}

std::vector<Finding> blow_response_findings(
    const TestBundle& bundle,
    const std::vector<BlowResponse>& responses,
    const BlowResponseLimits& limits) {
  std::vector<Finding> findings;
  std::vector<std::size_t> backwards;
  double backwards_gain = 1.0;
  for (std::size_t r = 0; r < bundle.runs.size(); ++r) {
    const auto in_run =
        those(responses, [r](const BlowResponse& b) { return b.run == r; });
    if (!is_backwards(in_run, limits)) continue;
    backwards.push_back(r);
    backwards_gain = std::min(backwards_gain, median_gain(in_run));
  }
  for (std::size_t c = 0; c < bundle.channels.size(); ++c) {
    std::vector<std::size_t> silent;
    double gain = 1.0;
    for (std::size_t r = 0; r < bundle.runs.size(); ++r) {
      if (std::ranges::count(backwards, r) > 0) continue;
      const auto own = those(responses, [&](const BlowResponse& b) {
        return b.run == r && b.channel == c;
      });
      if (own.size() < 2 || median_gain(own) > limits.silent) continue;
      if (expected_gain(responses, r, c, limits.heard) <= limits.heard)
        continue;
      silent.push_back(r);
      gain = median_gain(own);
    }
    if (!silent.empty()) {
      findings.push_back(
          silent_finding(bundle.channels[c].name, std::move(silent), gain));
    }
  }
  if (!backwards.empty()) {
    findings.push_back(backwards_finding(std::move(backwards), backwards_gain));
  }
  return findings;
}

}  // namespace tapfit::acquisition
