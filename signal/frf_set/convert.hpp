// Between the three forms of a mechanical FRF, at s = sigma + j omega:
//
//   accelerance A = s^2 R,   mobility M = s R,   receptance R
#pragma once

#include <Eigen/Core>

#include <cmath>
#include <complex>

namespace tapfit::signal {

enum class FrfForm { Receptance, Mobility, Accelerance };

/// Turns an FRF from one form into another.
///
/// A line at s = 0, where an accelerance says nothing about the others,
/// becomes zero rather than infinite.
///
/// @param H values per line, s the lines [rad/s], both n_lines
/// @return n_lines, (m or m/s or m/s^2) per N
[[nodiscard]] inline Eigen::VectorXcd convert(
    const Eigen::Ref<const Eigen::VectorXcd>& H,
    const Eigen::Ref<const Eigen::VectorXcd>& s,
    FrfForm from,
    FrfForm to) {
  const int power = static_cast<int>(to) - static_cast<int>(from);
  Eigen::VectorXcd result = H;
  for (Eigen::Index i = 0; i < H.size(); ++i) {
    for (int p = 0; p < power; ++p) result(i) *= s(i);
    for (int p = 0; p < -power; ++p)
      result(i) = std::abs(s(i)) > 0.0 ? result(i) / s(i) : 0.0;
  }
  return result;
}

}  // namespace tapfit::signal
