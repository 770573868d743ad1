// How well the poles of a refined fit are known.
#pragma once

#include "modal/fit/fit_noise.hpp"
#include "modal/fit/modal_model.hpp"
#include "modal/poles/weighted_frfs.hpp"

#include <Eigen/Core>

namespace tapfit::modal {

/// Covariance of the poles of a refined fit, from the FRFs' variance or from
/// what the fit leaves, whichever is larger. Neighbouring lines of an
/// exponentially windowed block are correlated; that is accounted for.
///
/// @return 2 n_modes square, (Re lambda_1, Im lambda_1, Re lambda_2, ...)
///   [(rad/s)^2]
[[nodiscard]] Eigen::MatrixXd pole_covariance(
    const WeightedFrfs& curves,
    const ModalFit& fit,
    NoiseFrom from = NoiseFrom::NearLines);

/// The same where the noise is known already.
[[nodiscard]] Eigen::MatrixXd pole_covariance(const WeightedFrfs& curves,
                                              const ModalFit& fit,
                                              const Noise& noise);

}  // namespace tapfit::modal
