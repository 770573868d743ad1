// What an FRF tends to at its lowest lines: the inertia of a free body, the
// stiffness of a held one, or neither.
//
//   free:   A(s)       = a + b s^2,   a = 1 / m (of a body hit at its centre;
//                                     less mass away from it)
//   held:   A(s) / s^2 = a + b s^2,   a = 1 / k
//
// a and b are real; b is what the modes above add, to the first order. Both are
// fitted to the lowest octave, every line counted by its own size, and a is
// what is left at s = 0.
//
// Source: D. J. Ewins, "Modal testing", 2nd ed. 2000, 3.11 (mass and stiffness
// lines as a check of calibration).
#pragma once

#include "signal/frf_set/frf_set.hpp"

namespace tapfit::signal {

enum class LowLine { Neither, Mass, Stiffness };

struct LowLines {
  LowLine kind = LowLine::Neither;
  /// 1 / a: kg with Mass, N/m with Stiffness; below zero where the response
  /// points the other way.
  double value = 0.0;
};

/// @param s lines, ascending; fewer than four in the lowest octave give Neither
/// @param frf with the sign of its degrees of freedom as it stands
[[nodiscard]] LowLines low_lines(const Eigen::VectorXcd& s, const Frf& frf);

}  // namespace tapfit::signal
