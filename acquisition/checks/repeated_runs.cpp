#include "acquisition/checks/repeated_runs.hpp"

#include "acquisition/bundle/runs_alike.hpp"

#include <fmt/format.h>

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

}  // namespace

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
