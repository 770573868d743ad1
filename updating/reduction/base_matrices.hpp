// A model seen through the vectors of a reduced base.
#pragma once

#include "updating/corrections/correction.hpp"
#include "updating/reduction/point_rows.hpp"
#include "updating/reduction/stiffness_change.hpp"

#include <Eigen/Core>

#include <vector>

namespace tapfit::updating {

struct BaseMatrices {
  Eigen::MatrixXd K;  ///< r x r
  Eigen::MatrixXd M;
};

struct ReducedBase {
  PointRows rows;     ///< of V, for the deck's own grids
  Eigen::MatrixXd K;  ///< r x r at nominal properties, see StiffnessTerm
  /// Of the uncertain properties, see uncertain_parts.hpp.
  std::vector<std::vector<int>> part_power;
  std::vector<Eigen::MatrixXd> K_part;  ///< one per power, r x r
  std::vector<Eigen::MatrixXd> M_part;
  std::vector<Correction> corrections;  ///< the last factors of the parts
  std::vector<StiffnessTerm> terms;     ///< of the changes asked for

  [[nodiscard]] Eigen::Index size() const { return K.rows(); }
  /// @param factor of each uncertain property and correction
  /// @param p value of each term's parameter
  [[nodiscard]] BaseMatrices at(const std::vector<double>& factor,
                                const std::vector<double>& p) const;
  /// Other coordinates of the same span, or of a part of it: V Q.
  /// @param Q r x r or fewer; Q' M Q = I
  void turn(const Eigen::MatrixXd& Q);
};

}  // namespace tapfit::updating
