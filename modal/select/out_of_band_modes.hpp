// Modes beside the band: their tails reach into it, and poles of their own
// stand for them better than the residual terms do.
#pragma once

#include "modal/fit/modal_fit.hpp"

#include <complex>
#include <utility>

namespace tapfit::modal {

[[nodiscard]] bool in_band(const WeightedFrfs& curves,
                           const std::complex<double>& pole);

/// A pole that only stands for the modes beside the band.
[[nodiscard]] bool far_outside(const WeightedFrfs& curves,
                               const std::complex<double>& pole);

/// Lines not further from a pole's frequency than reach [rad/s]: the first and
/// how many.
[[nodiscard]] std::pair<Eigen::Index, Eigen::Index> lines_within(
    const WeightedFrfs& curves, const std::complex<double>& pole, double reach);

[[nodiscard]] Eigen::VectorXcd without(const Eigen::VectorXcd& poles,
                                       Eigen::Index leave_out);

/// The same poles in the order of their frequencies.
[[nodiscard]] ModalFit by_frequency(const WeightedFrfs& curves,
                                    const ModalFit& fit);

/// refine_poles() without the poles that run away from the band under it: there
/// the residual terms do the same, and with both the fit is all but singular,
/// so that sound modes lose their significance.
[[nodiscard]] ModalFit refine_in_reach(const WeightedFrfs& curves,
                                       Eigen::VectorXcd poles,
                                       int iterations);

/// Adds poles above and below the band where the misfit falls clearly.
void add_out_of_band_modes(const WeightedFrfs& curves, ModalFit& fit);

}  // namespace tapfit::modal
