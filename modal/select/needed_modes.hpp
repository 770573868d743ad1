// Which modes of a fit the FRFs need.
#pragma once

#include "modal/fit/modal_model.hpp"
#include "modal/poles/identify_options.hpp"
#include "modal/poles/weighted_frfs.hpp"

#include <Eigen/Core>

namespace tapfit::modal {

/// F of a mode that no ripple of leakage or of noise stands in for: what the
/// fit leaves without it is ten times the noise.
inline constexpr double surely_there = 100.0;

/// The mode that the FRFs need least, of those that they do not need at all or
/// that fail a hard check; -1 where there is none.
[[nodiscard]] Eigen::Index weakest_mode(const WeightedFrfs& curves,
                                        const ModalFit& fit,
                                        const IdentifyOptions& options);

/// The middle damping ratio of a fit's poles in the band.
[[nodiscard]] double usual_damping(const WeightedFrfs& curves,
                                   const ModalFit& fit);

/// Whether the FRFs need every mode of a fit, and none fails a hard check.
[[nodiscard]] bool are_needed(const WeightedFrfs& curves,
                              const ModalFit& fit,
                              const IdentifyOptions& options);

}  // namespace tapfit::modal
