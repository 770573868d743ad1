// Noise of the channels sent through the windows of a transform:
//
//   E|dY(s)|^2 = S(omega) sum_n w_n^2 exp(-2 sigma t_n)
//
// and how far apart two lines must be for their noise to differ:
//
//   B = 2 pi fs sum w^4 / (sum w^2)^2,  2 pi / T for a rectangle,
//   2 pi sigma for an exponential window
//
// (the integral of the squared correlation over frequency, by Parseval).
#pragma once

#include "signal/spectra/hit_blocks.hpp"

#include <Eigen/Core>

#include <vector>

namespace tapfit::signal {

/// Noise that the transform of one block carries before anything is hit.
struct LineNoise {
  Eigen::VectorXd response;   ///< per line, E|dY|^2
  Eigen::VectorXd force;      ///< per line, E|dF|^2
  Eigen::VectorXd bandwidth;  ///< per line, B of the response [rad/s]
};

/// @param s lines [rad/s]
/// @return per sensor, as HitBlocks::responses
[[nodiscard]] std::vector<LineNoise> line_noise(const Eigen::VectorXcd& s,
                                                const HitBlocks& blocks);

}  // namespace tapfit::signal
