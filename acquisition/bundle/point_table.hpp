// Gives points of the test's own their labels, as a test is read.
#pragma once

#include "acquisition/bundle/test_point.hpp"
#include "acquisition/foundation/dof.hpp"

#include <array>
#include <vector>

namespace tapfit::acquisition {

/// Directions at right angles to each other at one place are one point: of a
/// sensor of three axes, or of a blow along one of them.
class PointTable {
 public:
  /// @param first label that is free
  explicit PointTable(int first = 1) : next_(first) {}

  /// The degree of freedom for a direction at a place, each point once.
  /// @param site its label and axes do not count
  /// @param direction of unit length, in the site's axes
  Dof add(const TestPoint& site, const Eigen::Vector3d& direction);

  /// Takes a point as it is, with its label and axes; once for each label.
  void keep(const TestPoint& point);

  [[nodiscard]] std::vector<TestPoint> points() const;

 private:
  struct Entry {
    TestPoint point;
    std::array<bool, 3> taken{};  // axes that something is along
  };

  int next_;
  std::vector<Entry> entries_;
};

}  // namespace tapfit::acquisition
