#include "tui/widgets/structure_columns.hpp"

#include <limits>
#include <string>

namespace tapfit::tui {
namespace {

constexpr double none = std::numeric_limits<double>::quiet_NaN();

void add_axes(std::vector<NamedNumbers>& columns,
              const std::string& of,
              const std::string& unit,
              const Eigen::Matrix3Xd& values) {
  for (int axis = 0; axis < 3; ++axis) {
    columns.push_back({of + "xyz"[axis] + unit, values.row(axis)});
  }
}

/// Of the nodes that are there, at their columns.
template <class Values>
Eigen::Matrix3Xd at_points(const Wireframe& wire, const Values& values) {
  Eigen::Matrix3Xd placed =
      Eigen::Matrix3Xd::Constant(3, wire.points.cols(), none);
  for (const auto& [node, value] : values) {
    const auto found = wire.index.find(node);
    if (found != wire.index.end()) placed.col(found->second) = value;
  }
  return placed;
}

Eigen::VectorXd in_place(const Wireframe& wire, const std::vector<int>& nodes) {
  Eigen::VectorXd in = Eigen::VectorXd::Zero(wire.points.cols());
  for (const int node : nodes) {
    const auto found = wire.index.find(node);
    if (found != wire.index.end()) in[found->second] = 1.0;
  }
  return in;
}

Eigen::VectorXd marked(const Wireframe& wire, const std::vector<Mark>& marks) {
  Eigen::VectorXd values = Eigen::VectorXd::Constant(wire.points.cols(), none);
  for (const Mark& mark : marks) {
    const auto found = wire.index.find(mark.node);
    if (found != wire.index.end() && mark.value) {
      values[found->second] = *mark.value;
    }
  }
  return values;
}

}  // namespace

std::vector<NamedNumbers> structure_columns(const Wireframe& wire,
                                            const Scene& scene) {
  const Eigen::Index n = wire.points.cols();
  Eigen::VectorXd grids = Eigen::VectorXd::Constant(n, none);
  // Of a test's own points -label comes before label, which stays.
  for (const auto& [node, at] : wire.index) grids[at] = node;
  std::vector<NamedNumbers> columns{{"grid", std::move(grids)}};
  add_axes(columns, "", " [m]", wire.points);
  if (scene.shape.cols() == n) add_axes(columns, "model ", "", scene.shape);
  if (!scene.stems.empty()) {
    add_axes(columns, "measured ", "", at_points(wire, scene.stems));
  }
  if (!scene.highlighted.empty()) {
    columns.push_back({"in the place", in_place(wire, scene.highlighted)});
  }
  if (!scene.value_name.empty()) {
    columns.push_back({scene.value_name, marked(wire, scene.marks)});
  }
  return columns;
}

}  // namespace tapfit::tui
