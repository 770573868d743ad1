// Modes within a bandwidth of each other: as many poles as the FRFs can tell
// apart, no fewer and no more. Several modes under one pole betray themselves
// by residues of a rank above one (double_poles.hpp); two poles nearer than
// their uncertainty, or too near for their shapes to be read, are one pole,
// whatever its rank (repeated_poles.hpp).
#pragma once

#include "modal/fit/modal_fit.hpp"
#include "modal/poles/stabilisation.hpp"

#include <complex>
#include <vector>

namespace tapfit::modal {

/// Standard deviations that tell two poles apart.
inline constexpr double least_separation_sd = 3.0;

/// Whether two poles are within half a bandwidth, the wider one's.
[[nodiscard]] bool are_close(const ModalFit& fit,
                             Eigen::Index q,
                             Eigen::Index r);

/// Whether another pole is within half a bandwidth.
[[nodiscard]] bool is_crowded(const ModalFit& fit, Eigen::Index r);

/// Whether the residues of pole r are its own: no other pole is within half a
/// bandwidth, or each is told apart from it and leaves it a shape that can be
/// read.
[[nodiscard]] bool stands_alone(const WeightedFrfs& curves,
                                const ModalFit& fit,
                                Eigen::Index r);

/// Whether two poles lie further apart than noise puts them.
///
/// @param covariance of all poles, as pole_covariance() gives it
[[nodiscard]] bool are_told_apart(const Eigen::MatrixXd& covariance,
                                  const ModalFit& fit,
                                  Eigen::Index q,
                                  Eigen::Index r);

/// Puts several poles in place of one whose residues hold several shapes.
[[nodiscard]] ModalFit separate_close(const WeightedFrfs& curves,
                                      ModalFit fit,
                                      const IdentifyOptions& options);

/// Refines poles until they rest, for FRFs of one reference: whether two of its
/// poles are one is seen there. With more, poles of one frequency would part to
/// follow the noise, and are taken apart by their shapes.
[[nodiscard]] ModalFit at_rest_by_one_reference(const WeightedFrfs& curves,
                                                ModalFit fit);

/// Puts one pole in place of two that are not told apart.
///
/// @param shifting takes up poles that one reference shows as two, so near each
///   other that FRFs of slightly different poles would look the same
[[nodiscard]] ModalFit merge_unresolved_poles(
    const WeightedFrfs& curves,
    ModalFit fit,
    std::vector<std::complex<double>>& shifting);

}  // namespace tapfit::modal
