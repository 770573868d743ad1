// Poles that strayed when all were refined together.
//
// A mode that hardly shows in the references is a small part of the misfit. As
// long as a mode beside the band is not accounted for, its pole lowers the
// misfit more by going there, and the mode is lost though the diagram has it.
#pragma once

#include "modal/fit/modal_fit.hpp"
#include "modal/poles/identify_options.hpp"

#include <Eigen/Core>

namespace tapfit::modal {

/// Starts each lasting pole that the fit has lost once more from its place, and
/// keeps it where it stays there and the FRFs need every pole.
///
/// @param lasting poles of the diagram that last over its orders [rad/s]
/// @param fit refined from those, with the poles beside the band
[[nodiscard]] ModalFit recover_lost_poles(const WeightedFrfs& curves,
                                          const Eigen::VectorXcd& lasting,
                                          ModalFit fit,
                                          const IdentifyOptions& options);

}  // namespace tapfit::modal
