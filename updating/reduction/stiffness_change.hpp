// A change of the stiffness matrix that an effect makes and that is too wide
// for a few degrees of freedom: a support that gives, a joint that gives,
// elements that have lost stiffness, a member under axial force. It is told on
// the deck's own grids and elements; the base builds its matrix on the mesh
// that it solves.
#pragma once

#include "updating/effects/change_kind.hpp"
#include "updating/effects/effect_ref.hpp"

#include <Eigen/Core>

#include <cstddef>
#include <vector>

namespace tapfit::updating {

struct StiffnessChange {
  ChangeKind kind = ChangeKind::Elements;
  EffectRef of;       ///< whose it is
  int component = 3;  ///< 1..3, the direction measured
  /// For ChangeKind::Elements: what each parameter after the first scales.
  std::vector<std::vector<int>> beside = {};

  bool operator==(const StiffnessChange&) const = default;
};

/// What p may be.
struct ChangeRange {
  double included = 0.0;  ///< value that the base's K holds
  double absent = 0.0;    ///< value where the effect is not in the model
  double lower = 0.0;     ///< range that the base is good for
  double start = 0.0;     ///< lowers the most affected mode a few percent
  double upper = 0.0;
};

/// The change seen through a base: K(p) = K + (p - included) S(f); one term for
/// each parameter of the effect. What elements have lost is a share of the
/// stiffness that they would have, which depends on the uncertain properties
/// f as K does (uncertain_parts.hpp); springs do not.
struct StiffnessTerm : ChangeRange {
  EffectRef of = {};
  std::size_t parameter = 0;  ///< which of the effect's parameters p is
  Eigen::MatrixXd S = {};     ///< r x r, d K / d p at nominal properties
  std::vector<std::vector<int>> part_power = {};
  std::vector<Eigen::MatrixXd> S_part = {};  ///< one per power, r x r
  /// Of elements that are thinned, what goes with their thickness (see
  /// element_parts.hpp): stiffness T(f), which is not in S, and mass N(f), as S
  /// and S_part; 0 x 0 where they are not:
  ///   K(p) = K + (p - 1) S + (c - 1) T,   M(p) = M + (c - 1) N,
  /// c = thickness_left(p), see stiffness_loss.hpp.
  Eigen::MatrixXd T = {};
  std::vector<Eigen::MatrixXd> T_part = {};
  Eigen::MatrixXd N = {};
  std::vector<Eigen::MatrixXd> N_part = {};

  /// S(f).
  [[nodiscard]] Eigen::MatrixXd at(const std::vector<double>& factor) const;
  [[nodiscard]] bool is_thinned() const { return N.size() > 0; }
  /// T(f), N(f); 0 x 0 where the elements are not thinned.
  [[nodiscard]] Eigen::MatrixXd thickness_at(
      const std::vector<double>& factor) const;
  [[nodiscard]] Eigen::MatrixXd mass_at(
      const std::vector<double>& factor) const;
  /// d S / d f_j; 0 x 0 where it does not depend on it.
  [[nodiscard]] Eigen::MatrixXd slope(const std::vector<double>& factor,
                                      std::size_t j) const;
  /// d T / d f_j, d N / d f_j; 0 x 0 where it does not depend on it.
  [[nodiscard]] Eigen::MatrixXd thickness_slope(
      const std::vector<double>& factor, std::size_t j) const;
  [[nodiscard]] Eigen::MatrixXd mass_slope(const std::vector<double>& factor,
                                           std::size_t j) const;
};

}  // namespace tapfit::updating
