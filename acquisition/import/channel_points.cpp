#include "acquisition/import/channel_points.hpp"

#include "acquisition/instruments/point_names.hpp"

#include <algorithm>
#include <cctype>
#include <map>
#include <set>
#include <string>

namespace tapfit::acquisition {
namespace {

// Axes by what stands before them in names.
using Sensors = std::map<std::string, std::set<int>>;

Sensors sensors_in(const std::vector<const TimeRecord*>& records) {
  Sensors sensors;
  for (const TimeRecord* record : records) {
    const auto axis = axis_in_name(record->name);
    if (axis && !record->dof) {
      sensors[std::string(axis->sensor)].insert(axis->component);
    }
  }
  return sensors;
}

// A letter at the end of a word is an axis only beside another one.
bool is_axis_of(const AxisName& axis, const Sensors& sensors) {
  const std::string sensor(axis.sensor);
  if (sensor.empty() ||
      std::isalpha(static_cast<unsigned char>(sensor.back())) == 0) {
    return true;
  }
  return sensors.at(sensor).size() > 1;
}

}  // namespace

std::vector<Dof> points_for(const std::vector<const TimeRecord*>& records) {
  const Sensors sensors = sensors_in(records);
  int last = 0;
  for (const TimeRecord* record : records) {
    if (record->dof) last = std::max(last, record->dof->node);
  }
  std::map<std::string, int> nodes;  // by sensor, or by the whole name
  std::vector<Dof> points;
  for (const TimeRecord* record : records) {
    if (record->dof) {
      points.push_back(*record->dof);
      continue;
    }
    const auto axis = axis_in_name(record->name);
    const bool told = axis && is_axis_of(*axis, sensors);
    // No sensor's name begins with a line end.
    const std::string key =
        told ? std::string(axis->sensor) : "\n" + record->name;
    const auto [node, fresh] = nodes.try_emplace(key, last + 1);
    if (fresh) ++last;
    points.push_back({.node = node->second,
                      .component = told ? axis->component : 3,
                      .sign = told ? axis->sign : 1});
  }
  return points;
}

}  // namespace tapfit::acquisition
