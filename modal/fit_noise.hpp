// The noise that a fit of the modal model has to live with.
#pragma once

#include "modal/modal_fit.hpp"

#include <Eigen/Core>

namespace tapfit::modal {

/// Standard deviation of the weighted residual u v e: per line (rms over FRFs)
/// times per FRF (about 1).
struct Noise {
  Eigen::VectorXd per_line;
  Eigen::VectorXd per_frf;
};

/// From the FRFs' variance or what the fit leaves, whichever is larger.
[[nodiscard]] Noise weighted_noise(const Curves& curves, const ModalFit& fit);

/// x with every line's neighbours added as they are correlated by the window:
/// rho(d) = 1 / (1 + j d spacing / (2 sigma)).
///
/// @param x n_lines x m
/// @param ratio sigma / spacing; 0: not correlated
[[nodiscard]] Eigen::MatrixXcd correlate(const Eigen::MatrixXcd& x,
                                         double ratio);

}  // namespace tapfit::modal
