// Paths measured both ways that differ by a factor and nothing else. Where a
// point's sensor reads s times what it should and the hammer h times in the run
// that hit there,
//
//   A_ab / A_ba = (s_a / h_b) / (s_b / h_a) = x_a / x_b,   x_p = s_p h_p
//
// so that several paths from one point tell that it is that one, and never
// whether it is its sensor or the blow.
#pragma once

#include "signal/checks/frf_checks.hpp"

#include <cstddef>
#include <vector>

namespace tapfit::signal {

struct SharedFactor {
  Dof point;
  std::size_t channel = 0;         ///< that sits there
  std::size_t run = 0;             ///< that hit there
  double factor = 1.0;             ///< x_p, above zero
  std::vector<std::size_t> pairs;  ///< indices of those that it explains
};

/// Points whose factor explains two pairs and more, within a tenth. What two
/// such points have between them is the first one's.
[[nodiscard]] std::vector<SharedFactor> shared_factors(
    const FrfSet& set, const std::vector<Reciprocal>& pairs);

}  // namespace tapfit::signal
