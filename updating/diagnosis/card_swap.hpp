// A number of the deck that was written down wrongly, as what a diagnosis finds
// besides its effects.
#pragma once

#include "updating/diagnosis/diagnose_options.hpp"
#include "updating/diagnosis/diagnosis.hpp"
#include "updating/fit/fitter.hpp"

#include <optional>

namespace tapfit::updating {

/// Tries the deck's likely slips (card_slips.hpp) where no effect by itself
/// comes near the floor: through the deck's own base, and the best two, where
/// they leave clearly less than the deck as it is, in bases of their own.
///
/// @param fitter of a deck without effects
/// @param found what effects alone explain
/// @return the slip that leaves least, where it is far likelier than the deck
///   as it is and leaves clearly less than that and than any effect by itself
[[nodiscard]] std::optional<SetUpMistake> card_swap(
    const Fitter& fitter,
    const Diagnosis& found,
    const DiagnoseOptions& options,
    const Progress& progress);

}  // namespace tapfit::updating
