// Measured modes as data in the place of FRFs. Everything is divided by its
// standard deviation and given in units of one of them, sd, so that all data
// scatter alike and the error is one of frequencies: of mode r
//
//   w ln f,  w = sd / sd(ln f)          and, at every point k of the shapes,
//   q_k a u_k,  q_k = sd / sd(e_k)      against  q_k e_k,
//
// e the measured shape, real and of unit length, u the model's, and a the
// factor that fits best: what scale and sign a shape has says nothing. Damping
// is no datum.
#pragma once

#include "acquisition/foundation/dof.hpp"
#include "modal/mode_set/mode_set.hpp"

#include <Eigen/Core>

#include <utility>
#include <vector>

namespace tapfit::updating {

struct ModalData {
  double sd = 0.0;  ///< relative, of the frequencies: root mean square
  Eigen::VectorXd frequency_hz;      ///< p
  Eigen::VectorXd frequency_weight;  ///< w, p
  /// Where there are shapes at two points or more; else none.
  std::vector<Dof> dofs;
  Eigen::MatrixXd shape;         ///< e, points x p
  Eigen::MatrixXd shape_weight;  ///< q, points x p
  /// Set by hand: a measured mode and the mode of the model as the deck has it.
  std::vector<std::pair<Eigen::Index, Eigen::Index>> fixed;

  [[nodiscard]] Eigen::Index modes() const { return frequency_hz.size(); }
  [[nodiscard]] Eigen::Index points() const { return shape.rows(); }
  /// What a model is to respond: modes x (1 + points).
  [[nodiscard]] Eigen::MatrixXd response() const;
  /// The same without some of the modes.
  /// @param kept of the modes, ascending
  [[nodiscard]] ModalData only(const std::vector<Eigen::Index>& kept) const;
};

/// @param measured at least one mode, every frequency and value of a shape with
///   a standard deviation
[[nodiscard]] ModalData modal_data(const modal::ModeSet& measured);

/// The model's mode that a measured one is, and its shape beside it.
struct PairedMode {
  Eigen::Index model = 0;  ///< index of the model's mode
  double factor = 0.0;     ///< a
  Eigen::VectorXd u;       ///< at the points

  /// What a u changes by where u changes by du (columns).
  [[nodiscard]] Eigen::MatrixXd fitted_change(const Eigen::VectorXd& e,
                                              const Eigen::VectorXd& q,
                                              const Eigen::MatrixXd& du) const;
};

/// Every measured mode with a mode of its own of the model's, so that MAC minus
/// |ln frequency ratio| is largest over all; without shapes the frequencies
/// alone decide.
///
/// @param omega of the model's modes [rad/s], at least as many as measured
/// @param at_points the model's shapes, points x modes
/// @param fixed a measured mode and the model's, whatever they are like
[[nodiscard]] std::vector<PairedMode> paired_modes(
    const ModalData& data,
    const Eigen::VectorXd& omega,
    const Eigen::MatrixXd& at_points,
    const std::vector<std::pair<Eigen::Index, Eigen::Index>>& fixed = {});

/// Measured modes whose shape is like none of the model's within three times
/// their frequency: what they are the model does not have. Those set by hand
/// are not asked.
/// @return ascending
[[nodiscard]] std::vector<Eigen::Index> foreign_modes(
    const ModalData& data,
    const Eigen::VectorXd& omega,
    const Eigen::MatrixXd& at_points);

}  // namespace tapfit::updating
