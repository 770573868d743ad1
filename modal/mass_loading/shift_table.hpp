// The poles of all set-ups as one list of values, with the columns that are
// fitted to them.
#pragma once

#include <Eigen/Core>

#include <cstddef>
#include <optional>
#include <vector>

namespace tapfit::modal {

/// What is known of the poles of all set-ups.
struct ShiftData {
  Eigen::MatrixXd log_omega;  ///< ln|pole|, n_set_ups x n_modes
  Eigen::MatrixXd log_sd;     ///< its standard deviation; 0 where not found
  Eigen::VectorXd damping;    ///< ratio, n_modes
  /// Per sensor and set-up: its directions x n_modes, real parts of the shapes
  /// at the points where it then sat; no row where it was off.
  std::vector<std::vector<Eigen::MatrixXd>> phi;
  /// Standard deviation of each value of phi, on its own.
  std::vector<std::vector<Eigen::MatrixXd>> phi_sd;
  /// Relative standard deviation of a mode's whole shape, n_modes.
  Eigen::VectorXd scale_sd;
  /// Per set-up: the shapes at its hammer's point, 1 x n_modes, if that is the
  /// point that gave the shapes their scale; else no row.
  std::vector<Eigen::MatrixXd> hammer;
  /// The set-up in which that driving point was measured.
  std::optional<std::size_t> driving;
  bool scaled = false;  ///< unit modal mass [1/sqrt(kg)]
};

/// One row for each pole found; a mode found in one set-up only tells nothing
/// and is left out.
struct ShiftTable {
  std::vector<Eigen::Index> set_up;
  std::vector<Eigen::Index> mode;
  Eigen::VectorXd log_omega;
  Eigen::VectorXd variance;  ///< of log_omega, above 0
  Eigen::MatrixXd g;         ///< sum phi^2 / 2, n_rows x n_sensors
  Eigen::MatrixXd g_sd;      ///< from the shapes' errors

  [[nodiscard]] Eigen::Index rows() const { return log_omega.size(); }
};

[[nodiscard]] ShiftTable shift_table(const ShiftData& data);

/// a_r: one column per mode, 1 where the row is of that mode.
[[nodiscard]] Eigen::MatrixXd mode_columns(const ShiftTable& table);

/// c_k: one column per set-up.
[[nodiscard]] Eigen::MatrixXd set_up_columns(const ShiftTable& table);

/// Columns of a and b side by side.
[[nodiscard]] Eigen::MatrixXd beside(const Eigen::MatrixXd& a,
                                     const Eigen::MatrixXd& b);

/// Variance to use for y = X b with the scatter tau^2 that brings chi^2 down to
/// its degrees of freedom, and large residuals weighted down.
///
/// @param X n x p
/// @param variance of each row before, n, above 0
[[nodiscard]] Eigen::VectorXd robust_variance(const Eigen::MatrixXd& X,
                                              const Eigen::VectorXd& y,
                                              const Eigen::VectorXd& variance);

}  // namespace tapfit::modal
