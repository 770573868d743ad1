// What a change of a sensor between runs does to its modal constants: one
// factor in all modes, and where it was integrated, differentiated or late,
//
//   z -> g (s / s_0)^p e^(-s tau) z
//
// at the pole s of each mode; s_0 is the geometric mean of all |s|.
#pragma once

#include <Eigen/Core>

#include <vector>

namespace tapfit::modal {

struct SensorLaw {
  int power = 0;         ///< p; -1 is velocity for acceleration
  double delay_s = 0.0;  ///< tau

  [[nodiscard]] bool is_plain() const { return power == 0 && delay_s == 0.0; }

  /// Of each mode, but for g.
  [[nodiscard]] Eigen::VectorXcd factors(const Eigen::VectorXcd& poles) const;

  bool operator==(const SensorLaw&) const = default;
};

/// Laws that may explain what a sensor shows: integrated and differentiated
/// once and twice, with the slight delay that explains most, and the delay
/// alone that does, up to 50 ms.
/// @param z what it shows of each mode
/// @param seen what it should show, but for g
[[nodiscard]] std::vector<SensorLaw> laws_that_explain(
    const Eigen::VectorXcd& z,
    const Eigen::VectorXcd& seen,
    const Eigen::VectorXcd& poles);

}  // namespace tapfit::modal
