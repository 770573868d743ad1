// Identified properties as changes of the deck's own cards.
#pragma once

#include "acquisition/bundle/test_bundle.hpp"
#include "updating/structure/deck/deck.hpp"
#include "updating/structure/edit/rescale_cards.hpp"

namespace tapfit::updating {

/// The fields that hold an uncertain property, and what depends on it, times a
/// factor. No fields for nu of a MAT1, which may stand beside a G.
///
/// @param uncertain one that property_law() accepts
[[nodiscard]] structure::CardScale property_card(
    const structure::Deck& deck,
    const acquisition::UncertainProperty& uncertain,
    double factor);

}  // namespace tapfit::updating
