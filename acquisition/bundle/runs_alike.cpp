#include "acquisition/bundle/runs_alike.hpp"

#include <algorithm>
#include <map>
#include <utility>

namespace tapfit::acquisition {
namespace {

using At = std::pair<std::size_t, Dof>;

// The hammer, then the sensors in an order of their own.
std::vector<At> placement_of(const Run& run) {
  std::vector<At> all{{run.hammer.channel, run.hammer.dof}};
  for (const Placement& sensor : run.sensors) {
    all.emplace_back(sensor.channel, sensor.dof);
  }
  std::sort(all.begin() + 1, all.end());
  return all;
}

}  // namespace

std::vector<RunGroup> runs_alike(const TestBundle& bundle) {
  std::vector<RunGroup> groups;
  std::map<std::vector<At>, std::size_t> known;
  for (std::size_t r = 0; r < bundle.runs.size(); ++r) {
    const auto [group, fresh] =
        known.try_emplace(placement_of(bundle.runs[r]), groups.size());
    if (fresh) groups.emplace_back();
    groups[group->second].push_back(r);
  }
  return groups;
}

std::size_t group_of(const std::vector<RunGroup>& groups, std::size_t run) {
  const auto own = std::ranges::find_if(groups, [run](const RunGroup& group) {
    return std::ranges::binary_search(group, run);
  });
  return static_cast<std::size_t>(own - groups.begin());
}

Run arranged_as(const Run& like, Run run) {
  run.sensors = like.sensors;
  return run;
}

}  // namespace tapfit::acquisition
