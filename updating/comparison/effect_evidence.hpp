// What one effect of a model does for it: the error with and without it, and
// the FRF where that shows most.
#pragma once

#include "updating/comparison/comparison.hpp"

#include <Eigen/Core>

#include <cstddef>
#include <optional>

namespace tapfit::updating {

struct EffectEvidence {
  double error_without = 0.0;  ///< relative FRF error, all else fitted anew
  double error_with = 0.0;
  /// The one whose error it lowers most; none of a test of modes.
  std::optional<std::size_t> frf;
  double frf_error_without = 0.0;  ///< of that one
  double frf_error_with = 0.0;
  Eigen::VectorXcd without;  ///< that one of the model, as Comparison's
  Eigen::VectorXcd with;
};

/// @param without,with two models of one test, compared on the same lines
[[nodiscard]] EffectEvidence effect_evidence(const Comparison& without,
                                             const Comparison& with);

}  // namespace tapfit::updating
