#include "acquisition/bundle/test_point.hpp"

#include <algorithm>

namespace tapfit::acquisition {

bool needs_model(const TestPoint& point) {
  return !point.at || point.system != 0;
}

const TestPoint* find_point(const std::vector<TestPoint>& points, int label) {
  const auto found = std::ranges::find(points, label, &TestPoint::label);
  return found == points.end() ? nullptr : &*found;
}

}  // namespace tapfit::acquisition
