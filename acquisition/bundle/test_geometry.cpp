#include "acquisition/bundle/test_geometry.hpp"

#include "acquisition/foundation/named_axes.hpp"

#include <fmt/format.h>

namespace tapfit::acquisition {

Dof at_own_point(const TestGeometry& geometry, const Dof& dof) {
  const auto own = geometry.directions.find(dof.node);
  if (own == geometry.directions.end()) {
    return {-dof.node, dof.component, dof.sign};
  }
  const auto axis = static_cast<Eigen::Index>((dof.component - 1) % 3);
  const auto named = along_one_of(named_like_basic(own->second),
                                  dof.sign * own->second.col(axis));
  const int kind = dof.component > 3 ? 3 : 0;
  return {-dof.node, named->component + kind, named->sign};
}

TestPoint own_point(const TestGeometry& geometry, int label) {
  TestPoint point;
  point.label = label;
  point.at = geometry.nodes.at(label);
  point.of_node = label;
  const auto own = geometry.directions.find(label);
  if (own != geometry.directions.end()) {
    point.axes = named_like_basic(own->second);
  }
  point.place =
      fmt::format("{}: point {}", geometry.file.filename().string(), label);
  return point;
}

}  // namespace tapfit::acquisition
