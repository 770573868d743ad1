// The noise that a fit of the modal model has to live with.
#pragma once

#include "modal/fit/modal_model.hpp"
#include "modal/poles/weighted_frfs.hpp"

#include <Eigen/Core>

namespace tapfit::modal {

/// Where the noise of a line is learnt from: a few lines around it, or also
/// from what all lines say is in proportion to the FRFs. The latter is for what
/// is told of modes; a fit that still lacks some has its misfit there.
enum class NoiseFrom { NearLines, AllLines };

/// Of the weighted residual u v e.
struct Noise {
  Eigen::VectorXd per_line;  ///< standard deviation, rms over the FRFs
  Eigen::MatrixXd power;     ///< each FRF's variance, n_lines x n_frfs
};

/// From the FRFs' variance or what the fit leaves, whichever is larger, both
/// over a few lines.
///
/// @param from all lines: not below what they say is in proportion to the FRFs,
///   for resonances with no lines beside the peak
[[nodiscard]] Noise weighted_noise(const WeightedFrfs& curves,
                                   const ModalFit& fit,
                                   NoiseFrom from);

/// Standard deviation of each FRF's noise over `per_line` where each mode is
/// told from: an FRF in which a mode is large mostly has more noise there.
///
/// @param X what the noise is projected on, times per_line: n_lines x 2 n_modes
/// @return n_frfs x n_modes, about 1
[[nodiscard]] Eigen::MatrixXd noise_at_modes(const Noise& noise,
                                             const Eigen::MatrixXcd& X);

/// Re x' C x / 2 with the correlation C that the window gives lines d apart,
/// rho(d) = 1 / (1 + j d spacing / (2 sigma)).
///
/// @param x n_lines x m
/// @param ratio sigma / spacing; 0: not correlated
/// @return m square
[[nodiscard]] Eigen::MatrixXd correlated_gram(const Eigen::MatrixXcd& x,
                                              double ratio);

}  // namespace tapfit::modal
