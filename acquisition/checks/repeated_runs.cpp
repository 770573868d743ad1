#include "acquisition/checks/repeated_runs.hpp"

#include "acquisition/bundle/runs_alike.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <utility>

namespace tapfit::acquisition {
namespace {

bool same_samples(const Recording& a, const Recording& b) {
  return a.samples.rows() > 0 && a.samples.rows() == b.samples.rows() &&
         a.samples.cols() == b.samples.cols() && a.samples == b.samples;
}

Finding repeated_finding(const TestBundle& bundle,
                         std::size_t first,
                         std::size_t again) {
  const std::vector<RunGroup> groups = runs_alike(bundle);
  const bool one_placement = group_of(groups, first) == group_of(groups, again);
  return {
      one_placement ? Severity::Warning : Severity::Error,
      {{again}, {}, {}, {}},
      fmt::format("run {} ({}) holds the same samples as run {} ({})",
                  again + 1,
                  bundle.runs[again].file.filename().string(),
                  first + 1,
                  bundle.runs[first].file.filename().string()),
      one_placement
          ? "one recording is listed twice: its hits count twice, and the "
            "scatter comes out too small"
          : "one recording is listed at two placements, of which one is wrong",
      one_placement
          ? fmt::format("take runs[{}] out of test.json", again)
          : fmt::format("name the right file in runs[{}] or runs[{}] of "
                        "test.json, or take one of them out",
                        first,
                        again)};
}

using Samples = Eigen::Ref<const Eigen::VectorXd>;

// The converter's step: the least change that there is.
double step_of(const Samples& x) {
  const double peak = x.cwiseAbs().maxCoeff();
  double least = peak;
  for (Eigen::Index i = 1; i < x.size(); ++i) {
    const double change = std::abs(x(i) - x(i - 1));
    // Below that it is rounding of the scaling to SI.
    if (change > 1e-10 * peak) least = std::min(least, change);
  }
  return least;
}

bool same_signal(const Samples& x, const Samples& y) {
  constexpr double steps = 2.0;
  constexpr double fewest_steps = 100.0;
  const double square = x.squaredNorm();
  if (!(square > 0.0) || !(y.squaredNorm() > 0.0)) return false;
  const double factor = x.dot(y) / square;
  const double apart = (y - factor * x).cwiseAbs().maxCoeff();
  const double size = y.cwiseAbs().maxCoeff();
  if (apart > size / fewest_steps) return false;
  const double allowed = steps * (step_of(y) + std::abs(factor) * step_of(x));
  return size > fewest_steps * allowed && apart <= allowed;
}

std::vector<std::size_t> channels_of(const Run& run) {
  std::vector<std::size_t> channels{run.hammer.channel};
  for (const Placement& sensor : run.sensors) {
    channels.push_back(sensor.channel);
  }
  std::ranges::sort(channels);
  return channels;
}

Finding one_signal_finding(const TestBundle& bundle,
                           std::size_t first,
                           std::size_t again,
                           std::vector<std::size_t> runs) {
  const std::string& one = bundle.channels[first].name;
  const std::string& other = bundle.channels[again].name;
  return {Severity::Error,
          {std::move(runs), other, {}, {}},
          fmt::format("{} and {} hold the same signal", one, other),
          "one input was recorded twice: a channel chosen wrongly at the front "
          "end, or a column copied",
          fmt::format("take {} or {} out of `sensors` of these runs, whichever "
                      "was not connected to this input",
                      one,
                      other)};
}

}  // namespace

std::vector<Finding> repeated_channel_findings(
    const TestBundle& bundle, const std::vector<Recording>& recordings) {
  std::map<std::pair<std::size_t, std::size_t>, std::vector<std::size_t>> same;
  for (std::size_t r = 0; r < recordings.size(); ++r) {
    const Eigen::MatrixXd& samples = recordings[r].samples;
    if (samples.rows() == 0) continue;
    const std::vector<std::size_t> channels = channels_of(bundle.runs[r]);
    for (auto one = channels.begin(); one != channels.end(); ++one) {
      for (auto other = one + 1; other != channels.end(); ++other) {
        if (same_signal(samples.col(static_cast<Eigen::Index>(*one)),
                        samples.col(static_cast<Eigen::Index>(*other)))) {
          same[{*one, *other}].push_back(r);
        }
      }
    }
  }
  std::vector<Finding> findings;
  for (auto& [channels, runs] : same) {
    findings.push_back(one_signal_finding(
        bundle, channels.first, channels.second, std::move(runs)));
  }
  return findings;
}

std::vector<Finding> repeated_run_findings(
    const TestBundle& bundle, const std::vector<Recording>& recordings) {
  std::vector<Finding> findings;
  for (std::size_t again = 1; again < recordings.size(); ++again) {
    for (std::size_t first = 0; first < again; ++first) {
      if (!same_samples(recordings[first], recordings[again])) continue;
      findings.push_back(repeated_finding(bundle, first, again));
      break;
    }
  }
  return findings;
}

}  // namespace tapfit::acquisition
