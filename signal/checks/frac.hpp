// Frequency response assurance criterion: do two FRFs have the same shape?
//
//   FRAC = |a^H b|^2 / ((a^H a)(b^H b))
//
// Source: W. Heylen, S. Lammens, "FRAC: a consistent way of comparing
// frequency response functions", Int. Conf. on Identification in Engineering
// Systems, Swansea, 1996.
#pragma once

#include <Eigen/Core>

#include <algorithm>
#include <complex>

namespace tapfit::signal {

/// FRAC of two FRFs on the same lines: 1 same but for a complex factor, 0
/// nothing in common (and where one of them is zero throughout).
[[nodiscard]] inline double frac(const Eigen::Ref<const Eigen::VectorXcd>& a,
                                 const Eigen::Ref<const Eigen::VectorXcd>& b) {
  const double scale_a = a.stableNorm();
  const double scale_b = b.stableNorm();
  if (!(scale_a > 0.0) || !(scale_b > 0.0)) return 0.0;
  // Scaled first, so that receptances of 1e-9 do not underflow when squared.
  return std::min(1.0, std::norm((a / scale_a).dot(b / scale_b)));
}

}  // namespace tapfit::signal
