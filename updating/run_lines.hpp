// The lines of one run: everything FrfModel needs to walk over s, in the
// coordinates of the model's own modes. Internal to frf_model.
#pragma once

#include "updating/frf_model.hpp"
#include "updating/mode_turn.hpp"

#include <Eigen/Core>

#include <complex>
#include <optional>
#include <vector>

namespace tapfit::updating {

/// A degree of freedom acted on, with the effect that does.
struct Actor {
  std::optional<std::size_t> effect;  ///< none: the deck's own dashpots, s
  std::size_t group = 0;
  double weight = 1.0;
};

/// What a parameter does to the modes, and its position in pack().
struct TurningParameter {
  ModeTurn turn;
  std::size_t column = 0;
  double scale = 1.0;  ///< d / d ln p = p d / d p
};

/// What all runs of one evaluation share.
struct ModalState {
  const ModelState* state = nullptr;
  BaseModes modes;
  DampingOfModes damping;
  std::vector<int> owner;               ///< of state->zeta, of each mode; or -1
  std::vector<ConstantChange> changes;  ///< what is in the modes
  std::vector<PlacedEffect> beside;     ///< the effects without that
  std::vector<TurningParameter> turning;
  std::vector<std::size_t> first;  ///< column of each effect's parameters
  std::size_t first_zeta = 0;
};

/// Diagonal of H, the base's receptance in its modes; a column per line.
[[nodiscard]] Eigen::MatrixXcd flexibility(const ModalState& shared,
                                           const Eigen::VectorXcd& s);

struct RunLines {
  const ModalState* shared = nullptr;
  std::vector<Actor> actors;
  Eigen::MatrixXd B;  ///< modes x actors
  std::vector<WalkedPair> pairs;
  Eigen::MatrixXd responses;   ///< modes x response points
  Eigen::MatrixXd references;  ///< modes x reference points

  /// D (I + B' H B D)^-1 of eq. 15.
  [[nodiscard]] Eigen::MatrixXcd coupling(std::complex<double> s,
                                          const Eigen::VectorXcd& g) const;
  /// X = H* e for the points (eq. 15), X = H (points - B u).
  struct Columns {
    Eigen::MatrixXcd X;  ///< modes x points
    Eigen::MatrixXcd u;  ///< actors x points; empty without actors
  };
  [[nodiscard]] Columns columns(const Eigen::VectorXcd& g,
                                const Eigen::MatrixXcd& coupled,
                                const Eigen::MatrixXd& points) const;
  /// Fills the response of these pairs, with derivatives where out.dH is made.
  /// @param flexible modes x lines, see flexibility()
  void respond(const Eigen::VectorXcd& s,
               const Eigen::MatrixXcd& flexible,
               ModelResponse& out) const;

 private:
  // Of one line.
  struct Line {
    std::complex<double> s;
    Eigen::Index at = 0;
    Columns o;  // of the response points
    Columns i;  // of the reference points
  };
  // What a parameter that turns the modes changes of the modal rows.
  struct Turned {
    Eigen::MatrixXd responses;
    Eigen::MatrixXd references;
    Eigen::MatrixXd B;
  };
  void derive_turning(const Line& line,
                      const std::vector<Turned>& turned,
                      ModelResponse& out) const;
  void derive_law(const Line& line, ModelResponse& out) const;
  void derive_damping(const Line& line, ModelResponse& out) const;
  void derive_effects(const Line& line, ModelResponse& out) const;
};

}  // namespace tapfit::updating
