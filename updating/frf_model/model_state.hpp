// Everything of a model that can be fitted.
#pragma once

#include "updating/effects/effect_instance.hpp"

#include <Eigen/Core>

#include <vector>

namespace tapfit::updating {

/// Everything that can be fitted.
struct ModelState {
  std::vector<double> factor;  ///< uncertain property over nominal
  Eigen::VectorXd zeta;        ///< damping ratio of the first modes
  double zeta_other = 0.01;    ///< of all higher modes
  std::vector<EffectInstance> effects;

  [[nodiscard]] Eigen::Index parameters() const;
  /// The effect that gives all modes their damping, if any; zeta is empty then.
  [[nodiscard]] const EffectInstance* damping_law() const;
  /// Damping ratio of a mode that the law gives, or zeta_other.
  [[nodiscard]] double zeta_at(double omega) const;
};

/// Logarithms of the state's parameters: factors, zeta, then effects' p.
[[nodiscard]] Eigen::VectorXd pack(const ModelState& state);
[[nodiscard]] ModelState unpack(const ModelState& like,
                                const Eigen::VectorXd& theta);

}  // namespace tapfit::updating
