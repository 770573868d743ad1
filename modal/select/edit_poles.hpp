// Poles taken out and put in by hand, after the automatic selection.
#pragma once

#include "modal/fit/modal_fit.hpp"
#include "modal/poles/stabilisation.hpp"

#include <vector>

namespace tapfit::modal {

/// Carries out options.edits in their order: takes out the mode nearest to a
/// frequency, or puts in the steadiest pole of the diagram near it that is no
/// mode yet (where the diagram has none, a pole started there); refines all of
/// them. What is put in passes no hard check but that it is damped.
///
/// @param fit changed in place
/// @throws InputError when no mode lies within 2 % of a frequency to drop, or
///   the pole put in runs away by more than 2 %, loses its damping or cannot be
///   told from one that is there
void edit_poles(const Curves& curves,
                const std::vector<Track>& tracks,
                const IdentifyOptions& options,
                ModalFit& fit);

}  // namespace tapfit::modal
