// A number of the deck that was written down wrongly, as what a diagnosis finds
// besides its effects.
#pragma once

#include "updating/diagnosis/diagnose_options.hpp"
#include "updating/diagnosis/diagnosis.hpp"
#include "updating/fit/fitter.hpp"

#include <optional>

namespace tapfit::updating {

/// The likeliest of the deck's slips (card_slips.hpp), before any effect is
/// looked for: all through the deck's own base, and the best two, where they
/// leave clearly less than the deck as it is, in bases of their own. Where the
/// deck as it is comes near a floor that hides nothing, none is tried.
///
/// @param fitter of a deck without effects
/// @return the one that leaves least, where it is far likelier than the deck as
///   it is and leaves clearly less
[[nodiscard]] std::optional<SetUpMistake> likely_slip(
    const Fitter& fitter,
    const DiagnoseOptions& options,
    const Progress& progress);

/// Whether no effect can do better: it comes near what the deck put right can
/// come to, and the deck as it is stays clear of that.
/// @param as_written what a fit of the deck as it is leaves
/// @param floor of the deck put right
[[nodiscard]] bool explains_all(const SetUpMistake& slip,
                                double as_written,
                                double floor);

/// Whether it leaves clearly less than any effect by itself, none of which
/// comes near the floor.
/// @param found what effects alone explain
[[nodiscard]] bool leaves_less(const SetUpMistake& slip,
                               const Diagnosis& found,
                               double floor);

}  // namespace tapfit::updating
