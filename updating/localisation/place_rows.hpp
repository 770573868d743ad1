// What a place of the structure feels of a motion, as rows over the base's
// coordinates: the displacement of a grid, the strains of an element, the
// moment that passes through a line.
#pragma once

#include "updating/frf_model/frf_model.hpp"
#include "updating/places/location.hpp"

#include <Eigen/Core>

#include <map>
#include <vector>

namespace tapfit::updating {

/// Rows of the base for the elements and lines of its deck. The deck's own
/// elements are used, on the motion that the base has at the deck's grids.
class PlaceRows {
 public:
  explicit PlaceRows(const FrfModel& model);

  /// 1 x r: displacement of a grid along an axis.
  /// @param component 1..3
  [[nodiscard]] Eigen::MatrixXd grid(int node, int component) const;

  /// k x r, G' G = the element's stiffness; k is its number of strain states.
  [[nodiscard]] const Eigen::MatrixXd& element(int id) const;

  /// One row per grid of the joint: its moment over the square root of the
  /// length it passes through [N m / m^0.5]; two rows are multiplied to the
  /// effect of one unit of compliance per metre.
  [[nodiscard]] Eigen::MatrixXd joint(const Where& where) const;

 private:
  struct ElementRows {
    std::vector<int> grids;
    Eigen::MatrixXd K;       // 6n x 6n
    Eigen::MatrixXd motion;  // 6n x r
    Eigen::MatrixXd strain;  // k x r
  };
  const FrfModel* model_;
  std::map<int, ElementRows> elements_;
};

}  // namespace tapfit::updating
