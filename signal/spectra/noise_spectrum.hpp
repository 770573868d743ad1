// Noise of a channel before the hits, as a spectrum.
//
//   S(omega) = mean over stretches |sum_n h_n x_n exp(-j omega n dt)|^2 / sum
//   h^2
//
// is the variance per sample that white noise of the same strength at omega
// would have; the transform of noise under any window w then has the variance
// S(omega) sum_n w_n^2.
//
// Source: P. D. Welch, "The use of fast Fourier transform for the estimation
// of power spectra", IEEE Trans. Audio Electroacoustics 15(2), 1967.
#pragma once

#include <Eigen/Core>

#include <vector>

namespace tapfit::signal {

struct NoiseSpectrum {
  double step = 0.0;  ///< rad/s between values; 0: white, one value
  Eigen::VectorXd S;  ///< variance per sample [unit^2]

  /// Linear interpolation; held beyond the ends.
  [[nodiscard]] double at(double omega) const;
};

/// Averages the stretches' spectra and smooths them over neighbouring bins.
/// Stretches under 16 samples are left out; where there are no others, those of
/// 4 samples and more tell white noise. With none left the result is empty:
/// nothing is known of the noise.
///
/// @param stretches quiet samples with their offset removed
/// @param dt sampling interval [s]
[[nodiscard]] NoiseSpectrum noise_spectrum(
    const std::vector<Eigen::VectorXd>& stretches, double dt);

}  // namespace tapfit::signal
