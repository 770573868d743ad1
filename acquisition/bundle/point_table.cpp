#include "acquisition/bundle/point_table.hpp"

#include "acquisition/foundation/named_axes.hpp"

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <optional>

namespace tapfit::acquisition {
namespace {

using Eigen::Index;
using Eigen::Matrix3d;
using Eigen::Vector3d;

bool same_site(const TestPoint& a, const TestPoint& b) {
  return a.node == b.node && a.of_node == b.of_node && a.at == b.at &&
         a.height_m == b.height_m && a.system == b.system;
}

// The axes with those that are taken and, as another component, a direction at
// right angles to them; empty where it is not.
std::optional<NamedDirection> with_direction(const Matrix3d& axes,
                                             const std::array<bool, 3>& taken,
                                             const Vector3d& direction) {
  Index own = -1;
  Index kept = -1;
  for (Index axis = 0; axis < 3; ++axis) {
    if (taken.at(static_cast<std::size_t>(axis))) {
      const bool upright =
          std::abs(axes.col(axis).dot(direction)) <= as_written;
      if (!upright || kept >= 0) return {};
      kept = axis;
    } else if (own < 0 ||
               std::abs(direction(axis)) > std::abs(direction(own))) {
      own = axis;
    }
  }
  if (own < 0 || kept < 0) return {};
  NamedDirection named;
  named.component = static_cast<int>(own) + 1;
  named.sign = direction(own) < 0.0 ? -1 : 1;
  named.axes = axes;
  named.axes.col(own) = named.sign * direction;
  const Index third = 3 - own - kept;
  Vector3d across = named.axes.col(own).cross(axes.col(kept)).normalized();
  if (across(third) < 0.0) across = -across;
  named.axes.col(third) = across;
  return named;
}

Dof dof_at(const TestPoint& point, const NamedDirection& named) {
  return {-point.label, named.component, named.sign};
}

}  // namespace

Dof PointTable::add(const TestPoint& site, const Vector3d& direction) {
  for (Entry& entry : entries_) {
    if (!same_site(entry.point, site)) continue;
    auto named = along_one_of(entry.point.axes, direction);
    if (!named) {
      named = with_direction(entry.point.axes, entry.taken, direction);
    }
    if (!named) continue;
    entry.point.axes = named->axes;
    entry.taken.at(static_cast<std::size_t>(named->component - 1)) = true;
    return dof_at(entry.point, *named);
  }
  const NamedDirection named = axes_along(direction);
  Entry entry{site, {}};
  entry.point.label = next_++;
  entry.point.axes = named.axes;
  entry.taken.at(static_cast<std::size_t>(named.component - 1)) = true;
  entries_.push_back(entry);
  return dof_at(entry.point, named);
}

void PointTable::keep(const TestPoint& point) {
  const bool known = std::ranges::any_of(entries_, [&](const Entry& entry) {
    return entry.point.label == point.label;
  });
  if (!known) entries_.push_back({point, {true, true, true}});
}

std::vector<TestPoint> PointTable::points() const {
  std::vector<TestPoint> points;
  for (const Entry& entry : entries_) points.push_back(entry.point);
  return points;
}

}  // namespace tapfit::acquisition
