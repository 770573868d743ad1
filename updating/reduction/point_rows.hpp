// The rows of a base for the deck's own grids, worked out where they are asked
// for: a base is turned often, and few of its rows are ever looked at.
//
//   rows = [shared, own] Q
//
// Columns of its own are orthonormal in the mass matrix to the shared ones, and
// are kept in single precision: as many bases as hypotheses are fitted have
// them, and FRFs through a base are good to 1e-6 at best. Of a large deck a fit
// asks for the rows of a few points, and only these are kept.
#pragma once

#include <Eigen/Core>

#include <cstddef>
#include <functional>
#include <memory>
#include <vector>

namespace tapfit::updating {

/// 6 n_grids x r: how a base's coordinates move each degree of freedom.
class PointRows {
 public:
  PointRows() = default;
  /// The columns themselves, which those made by with() share.
  explicit PointRows(Eigen::MatrixXd columns);

  /// The same with columns of its own behind, which are rounded; once.
  [[nodiscard]] PointRows with(const Eigen::MatrixXd& columns) const;
  /// Keeps of its own columns the rows of these degrees of freedom alone.
  /// @param again the columns as they were given to with(), asked for at most
  ///   once, where another row is; from any thread
  void keep_only(std::vector<int> dofs, std::function<Eigen::MatrixXd()> again);
  /// Numbers that it holds of its own.
  [[nodiscard]] Eigen::Index own_numbers() const;
  /// In other coordinates of the same span, or of a part of it: rows Q.
  void turn(const Eigen::MatrixXd& Q);
  /// Makes those of degrees of freedom that do not move in this span, which
  /// are zero but for rounding, exactly that.
  void set_at_rest(const std::vector<int>& dofs);

  [[nodiscard]] Eigen::Index rows() const;
  [[nodiscard]] Eigen::Index cols() const { return Q_.cols(); }
  [[nodiscard]] Eigen::RowVectorXd row(Eigen::Index dof) const;
  [[nodiscard]] Eigen::MatrixXd rows_of_grid(std::size_t grid) const;
  [[nodiscard]] Eigen::MatrixXd all() const;
  /// rows X, without working the rows out.
  [[nodiscard]] Eigen::MatrixXd operator*(const Eigen::MatrixXd& X) const;

 private:
  class OwnColumns;

  std::shared_ptr<const Eigen::MatrixXd> shared_;
  std::shared_ptr<const OwnColumns> own_;  // null: none
  Eigen::MatrixXd Q_;                      // columns of both x r
  std::vector<Eigen::Index> at_rest_;      // ascending
};

}  // namespace tapfit::updating
