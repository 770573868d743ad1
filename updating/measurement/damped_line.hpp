// The lines s = sigma + j omega on which measurement and model are compared.
//
// Near a lightly damped resonance a frequency error of 1 % is an FRF error of
// 100 %. At s = omega (delta + j) every peak is delta wide relative to its
// frequency, so that the comparison is nearly linear in frequency shifts up to
// delta. For the measurement it is an exponential window, for the model exact.
#pragma once

#include <Eigen/Core>

#include <array>
#include <string>

namespace tapfit::updating {

struct DampedLineOptions {
  double delta = 0.03;  ///< sigma / omega
  int max_lines = 160;
};

/// Lines over the band, spaced by the width of a peak there (sigma / omega of
/// the frequency).
///
/// sigma is at least 5 / T, so that the window has decayed at the block's end.
///
/// @param band_hz lower and upper frequency
/// @param block_s T, length of the block after the trigger
/// @return s [rad/s], ascending in frequency
[[nodiscard]] Eigen::VectorXcd damped_line(std::array<double, 2> band_hz,
                                           double block_s,
                                           const DampedLineOptions& options);

/// The same in words, for results.
[[nodiscard]] std::string describe_line(std::array<double, 2> band_hz,
                                        const Eigen::VectorXcd& s,
                                        const DampedLineOptions& options);

}  // namespace tapfit::updating
