#include "updating/set_up/sheet_points.hpp"

#include "acquisition/bundle/runs_alike.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <map>
#include <set>
#include <utility>

namespace tapfit::effects {
namespace {

using acquisition::Placement;
using acquisition::Run;
using acquisition::TestBundle;

bool means_run(const Location& where, std::size_t run) {
  return where.runs.empty() ||
         std::ranges::find(where.runs, static_cast<int>(run) + 1) !=
             where.runs.end();
}

bool means(const Location& where, const Placement& p, const TestBundle& sheet) {
  const std::string& channel = sheet.channels[p.channel].name;
  return std::ranges::find(where.channels, channel) != where.channels.end() &&
         (where.nodes.empty() || where.nodes.front() == p.dof.node);
}

std::vector<int> from_one(const acquisition::RunGroup& group) {
  std::vector<int> runs;
  for (const std::size_t run : group) runs.push_back(static_cast<int>(run) + 1);
  return runs;
}

Location point_of(const std::set<std::size_t>& channels,
                  int grid,
                  const TestBundle& sheet) {
  Location where;
  for (const std::size_t channel : channels) {
    where.channels.push_back(sheet.channels[channel].name);
  }
  where.nodes = {grid};
  return where;
}

}  // namespace

std::vector<Location> written_points(const TestContext& context) {
  using Channels = std::set<std::size_t>;
  const TestBundle& sheet = *context.bundle;
  std::set<std::pair<int, Channels>> hammers;
  std::set<std::pair<int, Channels>> sensors;
  for (const Run& run : sheet.runs) {
    hammers.insert({run.hammer.dof.node, {run.hammer.channel}});
    std::map<int, Channels> at;
    for (const Placement& p : run.sensors) {
      at[p.dof.node].insert(p.channel);
      sensors.insert({p.dof.node, {p.channel}});
    }
    for (const auto& [grid, channels] : at) sensors.insert({grid, channels});
  }
  std::vector<Location> result;
  for (const auto* points : {&hammers, &sensors}) {
    for (const auto& [grid, channels] : *points) {
      result.push_back(point_of(channels, grid, sheet));
    }
  }
  return result;
}

std::vector<std::vector<int>> averaged_runs(const Location& where,
                                            const TestBundle& sheet) {
  std::vector<std::vector<int>> result;
  for (const acquisition::RunGroup& group : acquisition::runs_alike(sheet)) {
    const Run& run = sheet.runs[group.front()];
    const bool there =
        means(where, run.hammer, sheet) ||
        std::ranges::any_of(run.sensors, [&](const Placement& p) {
          return means(where, p, sheet);
        });
    if (there) result.push_back(from_one(group));
  }
  return result;
}

std::string fault_of_runs(const Location& where, const TestBundle& sheet) {
  const auto count = static_cast<int>(sheet.runs.size());
  for (const int run : where.runs) {
    if (run < 1 || run > count) {
      return fmt::format("the test has no run {}", run);
    }
  }
  for (const acquisition::RunGroup& group : acquisition::runs_alike(sheet)) {
    const std::vector<int> runs = from_one(group);
    const auto named = std::ranges::count_if(runs, [&where](int run) {
      return std::ranges::find(where.runs, run) != where.runs.end();
    });
    if (named == 0 || named == std::ssize(runs)) continue;
    return fmt::format(
        "runs {} measured the same and are averaged: name all of them",
        fmt::join(runs, ", "));
  }
  return {};
}

bool is_hammer(const Location& where, const TestBundle& sheet) {
  return std::ranges::any_of(sheet.runs, [&](const Run& run) {
    return means(where, run.hammer, sheet);
  });
}

std::vector<Location> parted_by_runs(const Location& point,
                                     const TestBundle& sheet) {
  if (is_hammer(point, sheet)) return {};
  const std::vector<std::vector<int>> runs = averaged_runs(point, sheet);
  std::vector<Location> result;
  for (std::size_t cut = 1; cut < runs.size(); ++cut) {
    Location before = point;
    Location after = point;
    for (std::size_t k = 0; k < runs.size(); ++k) {
      std::vector<int>& part = (k < cut ? before : after).runs;
      part.insert(part.end(), runs[k].begin(), runs[k].end());
    }
    std::ranges::sort(before.runs);
    std::ranges::sort(after.runs);
    result.push_back(std::move(after));
    result.push_back(std::move(before));
  }
  return result;
}

void for_each_meant(const Location& where,
                    const TestBundle& written,
                    TestBundle& sheet,
                    const std::function<void(Placement&)>& change) {
  for (std::size_t r = 0; r < written.runs.size(); ++r) {
    if (!means_run(where, r)) continue;
    const Run& run = written.runs[r];
    Run& changed = sheet.runs[r];
    if (means(where, run.hammer, written)) change(changed.hammer);
    for (std::size_t k = 0; k < run.sensors.size(); ++k) {
      if (means(where, run.sensors[k], written)) change(changed.sensors[k]);
    }
  }
}

}  // namespace tapfit::effects
