// What a place of the structure feels of a motion, as rows over the base's
// coordinates: the displacement of a grid, the strains of an element, the
// moment that passes through a line.
#pragma once

#include "updating/frf_model/frf_model.hpp"
#include "updating/places/element_cells.hpp"
#include "updating/places/location.hpp"
#include "updating/structure/elements/element_matrices.hpp"

#include <Eigen/Core>

#include <cstddef>
#include <functional>
#include <map>
#include <vector>

namespace tapfit::updating {

/// Rows of the base for the elements and lines of its deck. The deck's own
/// elements are used, on the motion that the base has at the deck's grids.
class LocationOperators {
 public:
  explicit LocationOperators(const FrfModel& model);

  /// 1 x r: displacement of a grid along an axis.
  /// @param component 1..3
  [[nodiscard]] Eigen::MatrixXd grid(int node, int component) const;

  /// k x r, G' G = the stiffness of the elements; k is the number of strain
  /// states of one. Elements of a cell are strained alike: that in its middle,
  /// as often as there are some.
  [[nodiscard]] Eigen::MatrixXd cell(const ElementCell& cell);

  /// One row per grid of the joint: its moment over the square root of the
  /// length it passes through [N m / m^0.5]; two rows are multiplied to the
  /// effect of one unit of compliance per metre.
  [[nodiscard]] Eigen::MatrixXd joint(const Location& where);

  /// k x r, G' G = what a unit tension in the elements themselves, and a wire
  /// as long as the member that pulls at it, add to the stiffness; what else
  /// carries some of it is left out. No rows where they are no member.
  [[nodiscard]] Eigen::MatrixXd preload(const Location& where);

 private:
  [[nodiscard]] Eigen::MatrixXd motion_of(const std::vector<int>& grids);
  // Of an element, without mass; worked out when first asked for.
  const structure::ElementMatrices& element(int id);

  const FrfModel* model_;
  std::map<int, std::function<structure::ElementMatrices()>> matrices_;
  std::map<int, Eigen::Vector3d> middles_;
  std::map<std::size_t, Eigen::MatrixXd> motions_;  // of grids, 6 x r
  std::map<int, structure::ElementMatrices> known_;
};

}  // namespace tapfit::updating
