#include "updating/effects/sensor_channels.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <iterator>
#include <set>

namespace tapfit::effects {
namespace {

using structure::MeasuringPoint;

const MeasuringPoint* point_of(const structure::Deck& deck, int node) {
  const auto point =
      std::ranges::find(deck.measuring, node, &MeasuringPoint::grid);
  return point == deck.measuring.end() ? nullptr : &*point;
}

// In the order of the channel table.
std::vector<Location> on_each(const std::set<std::size_t>& channels,
                              const TestContext& context) {
  std::vector<Location> result;
  for (const std::size_t channel : channels) {
    result.push_back({.channels = {context.bundle->channels[channel].name}});
  }
  return result;
}

}  // namespace

std::vector<Location> sensor_places(const TestContext& context) {
  std::set<std::size_t> used;
  for (const acquisition::Run& run : context.bundle->runs) {
    for (const acquisition::Placement& p : run.sensors) used.insert(p.channel);
  }
  const std::vector<Location> each = on_each(used, context);
  if (each.size() < 2) return each;
  std::vector<Location> result(1);
  for (const Location& one : each) {
    result.front().channels.push_back(one.channels.front());
    result.push_back(one);
  }
  return result;
}

std::vector<Location> hammer_places(const TestContext& context) {
  std::set<std::size_t> used;
  for (const acquisition::Run& run : context.bundle->runs) {
    used.insert(run.hammer.channel);
  }
  return on_each(used, context);
}

std::vector<Location> channel_places(const TestContext& context) {
  std::vector<Location> result = sensor_places(context);
  std::erase_if(result,
                [](const Location& w) { return w.channels.size() > 1; });
  std::ranges::copy(hammer_places(context), std::back_inserter(result));
  return result;
}

int card_grid(const structure::Deck& deck, int node) {
  const MeasuringPoint* point = point_of(deck, node);
  return point == nullptr ? node : point->nearest;
}

int card_axis(const structure::Deck& deck, const Dof& dof) {
  const MeasuringPoint* point = point_of(deck, dof.node);
  if (point == nullptr) return dof.component;
  Eigen::Index axis = 0;
  point->axes.col((dof.component - 1) % 3).cwiseAbs().maxCoeff(&axis);
  return static_cast<int>(axis) + (dof.component > 3 ? 4 : 1);
}

std::vector<std::string> card_note(const structure::Deck& deck, int node) {
  const MeasuringPoint* point = point_of(deck, node);
  if (point == nullptr) return {};
  return {fmt::format("$ {} is {:.3g} mm from grid {}, the nearest",
                      node_name(node),
                      1e3 * point->to_grid,
                      point->nearest)};
}

std::vector<std::string> axis_note(const structure::Deck& deck,
                                   const Dof& dof) {
  const MeasuringPoint* point = point_of(deck, dof.node);
  if (point == nullptr) return {};
  const Eigen::Vector3d along = point->axes.col((dof.component - 1) % 3);
  constexpr double askew = 1e-3;
  if (along.cwiseAbs().maxCoeff() > 1.0 - askew) return {};
  return {fmt::format(
      "$ {} is along {:.4g}, {:.4g}, {:.4g}: of that component {} alone",
      name({dof.node, dof.component, 1}),
      along.x(),
      along.y(),
      along.z(),
      card_axis(deck, dof))};
}

std::vector<PlacedSensor> placed_sensors(const Location& where,
                                         const TestContext& context,
                                         std::size_t run) {
  std::vector<PlacedSensor> result;
  const acquisition::TestBundle& bundle = *context.bundle;
  for (const acquisition::Placement& p : bundle.runs.at(run).sensors) {
    const auto it = std::find(where.channels.begin(),
                              where.channels.end(),
                              bundle.channels[p.channel].name);
    if (it == where.channels.end()) continue;
    result.push_back(
        {p.dof, static_cast<std::size_t>(it - where.channels.begin())});
  }
  return result;
}

}  // namespace tapfit::effects
