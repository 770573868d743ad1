#include "acquisition/bundle/test_point.hpp"

#include <algorithm>

namespace tapfit::acquisition {

const TestPoint* find_point(const std::vector<TestPoint>& points, int label) {
  const auto found = std::ranges::find(points, label, &TestPoint::label);
  return found == points.end() ? nullptr : &*found;
}

}  // namespace tapfit::acquisition
