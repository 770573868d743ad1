// Why poles differ between set-ups, without a model of the structure.
//
// A sensor of mass m at a point where mode r has the value phi_r (unit modal
// mass) lowers its frequency by m phi_r^2 / 2 of it, so that over set-ups k
//
//   ln w_rk = a_r - sum_q m_q g_qrk + c_k + e_rk,   g = phi^2 / 2
//
// with a_r of the mode, c_k what moves all modes of a set-up by the same
// fraction (temperature, mostly), and noise e. Whether the masses explain more
// than chance would is an F test, in which only the scatter about the fit
// counts, not how small the poles' own standard deviations are. It is made with
// c_k where c_k is significant itself.
//
// The masses are then those at which the frequencies freed of them
// (modal/mass_loading/unloaded_modes.hpp) agree best. Weights: the poles'
// variance, what the shapes' errors make of it, twice the square of the shift
// for modes not found (also of one sign for all poles), and a scatter tau^2
// that brings chi^2 to its degrees of freedom (R. C. Paule, J. Mandel, J. Res.
// NBS 87, 1982, p. 377-385); large residuals are weighted down (P. J. Huber,
// Ann. Math. Stat. 35, 1964).
#pragma once

#include "modal/mode_set/pole_shifts.hpp"

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

/// Tells the cause of the shifts.
///
/// @return empty when there are too few set-ups and modes to tell anything
[[nodiscard]] std::optional<PoleShifts> explain_shifts(const ShiftData& data);

}  // namespace tapfit::modal
