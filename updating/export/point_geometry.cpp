#include "updating/export/point_geometry.hpp"

#include "acquisition/uff/uff_systems.hpp"

namespace tapfit::updating {
namespace {

void add_point(int node,
               const Eigen::Vector3d& at,
               const Eigen::Matrix3d& axes,
               acquisition::UffGeometry& geometry) {
  const int label = acquisition::uff_label(node);
  geometry.nodes[label] = at;
  geometry.node_systems[label] = {0, label, {}};
  acquisition::UffSystem system;
  system.points << at, at + axes.col(0), at + axes.col(2);
  geometry.systems[label] = system;
}

}  // namespace

acquisition::UffGeometry point_geometry(Session& session) {
  acquisition::UffGeometry geometry;
  const acquisition::TestBundle& bundle = session.bundle();
  if (bundle.points.empty()) return geometry;
  if (session.has_model()) {
    const structure::Deck& deck = session.deck();
    for (const structure::MeasuringPoint& point : deck.measuring) {
      add_point(point.grid,
                deck.grids[deck.grid_index(point.grid)].position,
                point.axes,
                geometry);
    }
    return geometry;
  }
  for (const acquisition::TestPoint& point : bundle.points) {
    if (acquisition::needs_model(point)) continue;
    add_point(-point.label, *point.at, point.axes, geometry);
  }
  return geometry;
}

}  // namespace tapfit::updating
