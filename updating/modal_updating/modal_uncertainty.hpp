// How far parameters identified from measured modes can be trusted.
//
//   A = Ff + Fs + P,   C = A^-1 (s_f^2 Ff + s_s^2 Fs + P) A^-1,   F = J'WJ
//
// for frequencies (f) and shapes (s). Each s^2, at least 1, is what its data
// miss by over what so many data may, some of them used up by the fit:
//
//   s^2 = r'Wr / (tr W - tr(A^-1 F))
//
// Source of s^2: W. Forstner, "Ein Verfahren zur Schatzung von Varianz- und
// Kovarianzkomponenten", Allgemeine Vermessungs-Nachrichten 86, 1979.
#pragma once

#include "updating/fit/identifiability.hpp"
#include "updating/modal_updating/modal_residual.hpp"

#include <Eigen/Core>

namespace tapfit::updating {

struct ModalUncertainty {
  Eigen::MatrixXd covariance;
  /// Infinite for what neither data nor prior determine.
  Eigen::VectorXd standard_error;
  Identifiability identifiability;  ///< by the data, without the prior
};

/// @param J d r / d theta, rows as in residual.r
/// @param frequencies how many of the first rows are frequencies
/// @param precision of the prior, 1 / sd^2, 0 where there is none
[[nodiscard]] ModalUncertainty modal_uncertainty(
    const Eigen::MatrixXd& J,
    const ModalResidual& residual,
    Eigen::Index frequencies,
    const Eigen::VectorXd& precision);

}  // namespace tapfit::updating
