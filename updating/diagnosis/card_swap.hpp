// A number of the deck that was written down wrongly, as what a diagnosis finds
// besides its effects.
#pragma once

#include "updating/diagnosis/diagnosis.hpp"
#include "updating/fit/fitter.hpp"

#include <optional>

namespace tapfit::updating {

/// Whether a deck leaves so much that a slip of all of it may be at fault: half
/// or twice the thickness and exchanged moduli move every mode, and of FRFs
/// that agree in part such a slip would make less. Of modes, which differ by
/// less than their FRFs, all are looked at: fits of them take no time.
/// @param plain a fit of the deck as it is
[[nodiscard]] bool may_be_slip(const Fit& plain, const Fitter& fitter);

/// The likeliest of the deck's slips (card_slips.hpp): all through the deck's
/// own base, and the best two, where they leave clearly less than the deck as
/// it is, in bases of their own. Numbers that are out of scale come before the
/// others, each unit in a base of its own.
/// @param fitter of a deck without effects
/// @return the one that leaves least, where it is far likelier than the deck as
///   it is and leaves clearly less
[[nodiscard]] std::optional<SetUpMistake> likely_slip(const Fitter& fitter,
                                                      const Progress& progress);

/// Whether it puts numbers right that no structure has: what is missing from a
/// deck with them need not be asked.
[[nodiscard]] bool is_out_of_scale(const SetUpMistake& slip,
                                   const structure::Deck& deck);

/// Whether no effect can do better: it comes near what the deck put right can
/// come to, and the deck as it is stays clear of that.
/// @param mended error that a fit of the deck put right leaves
/// @param as_written the same of the deck as it is
/// @param floor of the deck put right
[[nodiscard]] bool explains_all(double mended, double as_written, double floor);

/// Whether no effect by itself comes near the floor.
[[nodiscard]] bool none_explains(const Diagnosis& found, double floor);

/// Whether the slip leaves clearly less than any effect by itself.
[[nodiscard]] bool leaves_less(const SetUpMistake& slip,
                               const Diagnosis& found);

}  // namespace tapfit::updating
