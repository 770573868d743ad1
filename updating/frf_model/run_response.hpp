// The lines of one run: everything FrfModel needs to walk over s, in the
// coordinates of the model's own modes. Internal to frf_model.
#pragma once

#include "updating/frf_model/modal_derivatives.hpp"
#include "updating/frf_model/modal_modifications.hpp"
#include "updating/frf_model/model_modes.hpp"
#include "updating/frf_model/model_response.hpp"
#include "updating/frf_model/model_state.hpp"
#include "updating/frf_model/test_as_done.hpp"

#include <Eigen/Core>

#include <complex>
#include <optional>
#include <vector>

namespace tapfit::updating {

/// A degree of freedom acted on, with the effect that does.
struct CoupledDof {
  std::optional<std::size_t> effect;  ///< none: the deck's own dashpots, s
  std::size_t group = 0;
  double weight = 1.0;
};

/// What a parameter does to the modes, and its position in pack().
struct TurningParameter {
  ModalDerivative turn;
  std::size_t column = 0;
  double scale = 1.0;  ///< d / d ln p = p d / d p
};

/// What all runs of one evaluation share.
struct ModalState {
  const ModelState* state = nullptr;
  TestAsDone done;
  BaseModes modes;
  DampingOfModes damping;
  std::vector<int> owner;  ///< of state->zeta, of each mode; or -1
  std::vector<ModalModification> changes;  ///< what is in the modes
  std::vector<EffectInstance> beside;      ///< the effects without that
  std::vector<TurningParameter> turning;
  std::vector<std::size_t> first;  ///< column of each effect's parameters
  std::size_t first_zeta = 0;
};

/// Diagonal of H, the base's receptance in its modes; a column per line.
[[nodiscard]] Eigen::MatrixXcd flexibility(const ModalState& shared,
                                           const Eigen::VectorXcd& s);

struct RunResponse {
  const ModalState* shared = nullptr;
  std::vector<CoupledDof> actors;
  Eigen::MatrixXd B;  ///< modes x actors
  std::vector<WalkedPair> pairs;
  Eigen::MatrixXd responses;   ///< modes x response points
  Eigen::MatrixXd references;  ///< modes x reference points

  /// D (I + B' H B D)^-1 of eq. 15.
  /// @param receptance B' H B of the base on this line, actors x actors
  [[nodiscard]] Eigen::MatrixXcd coupling(
      std::complex<double> s, const Eigen::MatrixXcd& receptance) const;
  /// X = H* e for the points (eq. 15), modes x points.
  [[nodiscard]] Eigen::MatrixXcd columns(const Eigen::VectorXcd& g,
                                         const Eigen::MatrixXcd& coupled,
                                         const Eigen::MatrixXd& points) const;
};

}  // namespace tapfit::updating
