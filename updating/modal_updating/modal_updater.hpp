// The room updating/modal_updating. Updating from measured modes alone. No
// command leads here yet.
// In:  Measured modes and parts of K and M.
// Out: Shares of the parts with their uncertainty.
// May include: its row in CONTRIBUTING.md.
//
// Identifies the shares theta of a model's parts from measured modes alone:
// Levenberg-Marquardt on
//
//   J(theta) = misfit(theta) + sum ((theta - mean) / sd)^2
//
// with the misfit of modal_residual.hpp and the derivatives of
// mode_sensitivity.hpp. Modes are paired anew at every theta, so that they may
// change places on the way. A step is taken at the excess scatter v of the
// shapes; v is at its best again after it, which can only lower J further.
//
// Source: M. I. Friswell, J. E. Mottershead, "Finite Element Model Updating in
// Structural Dynamics", Kluwer, 1995, chapter 8.
#pragma once

#include "updating/fit/identifiability.hpp"
#include "updating/fit/updater.hpp"
#include "updating/modal_updating/modal_residual.hpp"

#include <optional>
#include <string>
#include <vector>

namespace tapfit::updating {

struct ModalUpdateOptions {
  int max_iterations = 100;
  double tolerance = 1e-6;  ///< on the largest change of a theta
  /// On the decrease of J that the next step promises; d standard errors away
  /// from its minimum J is d^2 above it.
  double objective_tolerance = 1e-8;
  modal::PairingOptions pairing;
  /// Independent readings in one shape, from 1 to one less than its points,
  /// which is the default. Where neighbouring points miss by the same, there
  /// are fewer than points.
  std::optional<double> independent;
};

struct ModalStep {
  double objective = 0.0;        ///< J after the step
  double length = 0.0;           ///< largest change of a theta
  double damping = 0.0;          ///< Levenberg's
  Eigen::VectorXd theta;         ///< after the step
  Eigen::VectorXd frequency_hz;  ///< of the paired modes; 0: unpaired
};

struct ModalUpdate {
  Eigen::VectorXd theta;
  double objective = 0.0;  ///< J
  ModalResidual before;    ///< at the start
  ModalResidual after;     ///< at theta
  /// Of theta; see modal_uncertainty.hpp. It belongs to the minimum found: for
  /// another one the fit has to start elsewhere.
  Eigen::MatrixXd covariance;
  /// Its diagonal's root; infinite for what neither data nor prior determine.
  Eigen::VectorXd standard_error;
  std::vector<bool> at_bound;       ///< the error of such a theta is one-sided
  Identifiability identifiability;  ///< by the data, without the prior
  std::vector<ModalStep> history;   ///< the start, then each step
  bool converged = false;
  std::string message;  ///< why it stopped
};

/// Never returns a theta with a larger J than that of the start.
///
/// @param prior of theta; `lower` and `upper` keep parts from turning negative
/// @param start within the bounds
/// @throws InputError for matrices, modes or a prior that cannot be used, and
///   where the modes of the start cannot be solved for
[[nodiscard]] ModalUpdate modal_update(const ScaledModel& model,
                                       const MeasuredModes& measured,
                                       const Prior& prior,
                                       const Eigen::VectorXd& start,
                                       const ModalUpdateOptions& options = {},
                                       const Progress& progress = {});

}  // namespace tapfit::updating
