// The lines of one run: everything FrfModel needs to walk over s, in the
// coordinates of the model's own modes. Internal to frf_model.
#pragma once

#include "updating/frf_model.hpp"

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

/// Of every mode of unit mass: d = 2 zeta omega, and what it gains with modal
/// stiffness and mass.
struct DampingOfModes {
  Eigen::VectorXd d;
  Eigen::VectorXd by_k;  ///< d d / d k
  Eigen::VectorXd by_m;  ///< d d / d m
};

/// d Z / d f of a matrix term, in modal coordinates; diagonal where it can be.
class ModalTerm {
 public:
  ModalTerm(const Eigen::MatrixXd& phi,
            const Eigen::MatrixXd& K,
            const Eigen::MatrixXd* M);

  /// Lets modal damping turn with the modes. With Phi' = Phi A the matrix
  /// C = Phi^-T D Phi^-1, D = diag(2 zeta omega), changes off the diagonal by
  ///   -(A' D + D A)_ij = (k_ij (d_j - d_i) + m_ij (l_j d_i - l_i d_j))
  ///                      / (l_j - l_i),   l = omega^2;
  /// A after R. L. Fox, M. P. Kapoor, AIAA Journal 6(12), 1968, p. 2426.
  void turn_damping(const Eigen::VectorXd& omega, const Eigen::VectorXd& d);

  /// d Z / d f times X; damping follows the frequencies.
  /// @param s the line of each column of X [rad/s]
  [[nodiscard]] Eigen::MatrixXcd times(const Eigen::VectorXcd& s,
                                       const DampingOfModes& damping,
                                       const Eigen::MatrixXcd& X) const;

 private:
  Eigen::VectorXd k_, m_;  // diagonals
  Eigen::MatrixXd K_, M_;  // full; empty where diagonal
  Eigen::MatrixXd C_;      // off the diagonal; empty where it does not turn
};

/// A matrix term and the parameter (position in pack()) that scales it.
struct ScaledTerm {
  ModalTerm term;
  std::size_t column = 0;
  double scale = 1.0;  ///< d / d ln p = p d / d p
};

/// What all runs of one evaluation share.
struct ModalState {
  const ModelState* state = nullptr;
  BaseModes modes;
  DampingOfModes damping;
  std::vector<int> owner;  ///< of state->zeta, of each mode; or -1
  std::vector<ScaledTerm> terms;
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
  /// X = H* e for the points (eq. 15).
  [[nodiscard]] Eigen::MatrixXcd columns(const Eigen::VectorXcd& g,
                                         const Eigen::MatrixXcd& coupled,
                                         const Eigen::MatrixXd& points) const;
  /// Fills the response of these pairs, with derivatives where out.dH is made.
  /// @param flexible modes x lines, see flexibility()
  void respond(const Eigen::VectorXcd& s,
               const Eigen::MatrixXcd& flexible,
               ModelResponse& out) const;

 private:
  // X of the response and of the reference points on one line.
  struct Columns {
    Eigen::MatrixXcd o;
    Eigen::MatrixXcd i;
  };
  void derive_terms(const Eigen::VectorXcd& s,
                    const std::vector<Columns>& X,
                    ModelResponse& out) const;
  void derive_law(std::complex<double> s,
                  Eigen::Index line,
                  const Columns& X,
                  ModelResponse& out) const;
  void derive_damping(std::complex<double> s,
                      Eigen::Index line,
                      const Columns& X,
                      ModelResponse& out) const;
  void derive_effects(std::complex<double> s,
                      Eigen::Index line,
                      const Columns& X,
                      ModelResponse& out) const;
};

}  // namespace tapfit::updating
