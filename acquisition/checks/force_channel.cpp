#include "acquisition/checks/force_channel.hpp"

#include "acquisition/foundation/parallel.hpp"
#include "acquisition/hits/judge_hits.hpp"
#include "acquisition/samples/statistics.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <optional>
#include <utility>

namespace tapfit::acquisition {
namespace {

using Eigen::Index;
using Eigen::VectorXd;

constexpr double out_of_noise = 6.0;
// Of its peak, what a signal must be seen to fall to for its length to be told.
constexpr double seen_to_fall = 0.1;
constexpr Index samples_for_middle = 4096;
// Another channel's energy must be this much shorter than the hammer's: it
// cannot be where the hammer's blows made it.
constexpr double clearly_shorter = 1.0 / 3.0;
// Contact of hammer and structure takes 0.1 to 20 ms (ISO 7626-5), of a
// pendulum with a rubber pad 50 ms.
constexpr double longest_blow_s = 0.1;

// The channel that holds the blows instead of the hammer's, if one does.
std::optional<std::size_t> blows_elsewhere(const Run& run,
                                           const Recording& recording) {
  if (recording.samples.rows() == 0) return {};
  const auto lasting = [&](std::size_t channel) {
    return effective_samples(
        recording.samples.col(static_cast<Index>(channel)));
  };
  const double hammer = lasting(run.hammer.channel);
  std::optional<std::size_t> shortest;
  double least = clearly_shorter * hammer;
  for (const Placement& sensor : run.sensors) {
    const double of = lasting(sensor.channel);
    if (of <= 0.0 || of >= least) continue;
    least = of;
    shortest = sensor.channel;
  }
  return shortest;
}

Finding exchanged_finding(const TestBundle& bundle,
                          std::size_t channel,
                          std::vector<std::size_t> runs) {
  const std::string& hammer =
      bundle.channels[bundle.runs[runs.front()].hammer.channel].name;
  const std::string& other = bundle.channels[channel].name;
  return {Severity::Error,
          {std::move(runs), other, {}, {}},
          fmt::format("the blows stand in {}, while {} rings like a response",
                      other,
                      hammer),
          fmt::format("{} and {} are exchanged, or the columns of the file "
                      "stand in another order",
                      hammer,
                      other),
          "list `channels` in test.json in the order of the file's columns"};
}

Finding slow_finding(const TestBundle& bundle,
                     const HitSet& hits,
                     double blow_s) {
  const std::string& hammer =
      bundle.channels[bundle.runs.front().hammer.channel].name;
  return {
      Severity::Error,
      {{}, hammer, {}, {}},
      fmt::format("a blow lasts {:.3g} s, and the sampling rate is {:.4g} "
                  "Hz",
                  blow_s,
                  hits.sample_rate_hz),
      fmt::format("the time column is in milliseconds: a blow of {:.3g} ms, "
                  "{:.4g} Hz",
                  blow_s,
                  1000.0 * hits.sample_rate_hz),
      fmt::format("import the files again with --rate {:.6g}",
                  1000.0 * hits.sample_rate_hz)};
}

}  // namespace

double effective_samples(const Eigen::Ref<const VectorXd>& channel) {
  const double middle = median(thinned(channel, samples_for_middle));
  const double noise = difference_noise(channel);
  const double peak = (channel.array() - middle).abs().maxCoeff();
  if (seen_to_fall * peak <= out_of_noise * noise) return 0.0;
  double square = 0.0;
  double fourth = 0.0;
  for (const double value : channel) {
    const double x = value - middle;
    if (std::abs(x) <= out_of_noise * noise) continue;
    square += x * x;
    fourth += x * x * x * x;
  }
  return fourth > 0.0 ? square * square / fourth : 0.0;
}

std::vector<Finding> force_channel_findings(
    const TestBundle& bundle,
    const std::vector<Recording>& recordings,
    const HitSet& hits) {
  std::vector<std::optional<std::size_t>> of(recordings.size());
  for_each_parallel(of.size(), [&](std::size_t r) {
    of[r] = blows_elsewhere(bundle.runs[r], recordings[r]);
  });
  std::map<std::size_t, std::vector<std::size_t>> exchanged;
  for (std::size_t r = 0; r < of.size(); ++r) {
    if (of[r]) exchanged[*of[r]].push_back(r);
  }
  std::vector<Finding> findings;
  for (auto& [channel, runs] : exchanged) {
    findings.push_back(exchanged_finding(bundle, channel, std::move(runs)));
  }
  if (!findings.empty()) return findings;
  std::vector<double> widths;
  for (const auto& run : hits.runs) {
    for (const Hit& hit : run) widths.push_back(hit.pulse_s);
  }
  const double blow_s = median(widths);
  if (blow_s > longest_blow_s) {
    findings.push_back(slow_finding(bundle, hits, blow_s));
  }
  return findings;
}

}  // namespace tapfit::acquisition
