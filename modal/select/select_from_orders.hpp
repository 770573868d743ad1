// Which model orders to select from. A mode returns over most of them, unless
// its resonance overlaps with its neighbours' (damping of some 10 %): then the
// many poles of a high order, and numerators of its degree, follow the noise.
#pragma once

#include "modal/poles/plscf.hpp"
#include "modal/select/select_modes.hpp"

#include <vector>

namespace tapfit::modal {

/// Selects from the tracks over all orders, then from those of a model of half
/// the order, and so on; a lower one counts where its modes explain clearly
/// more.
///
/// @param orders, tracks of the largest model
[[nodiscard]] Selection select_from_orders(
    const WeightedFrfs& curves,
    const FrfMatrix& matrix,
    const std::vector<OrderPoles>& orders,
    const std::vector<Track>& tracks,
    const IdentifyOptions& options,
    const Progress& progress);

}  // namespace tapfit::modal
