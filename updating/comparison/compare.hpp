// The room updating/comparison. Model against measurement.
// In:  A fit, measured FRFs and modes.
// Out: Comparison: error per FRF, band and point, pairs of modes, MAC, the
//      error's floor.
// May include: its row in CONTRIBUTING.md.
//
// Compares a fitted (or nominal) model with the measurement.
#pragma once

#include "modal/mode_set/mode_set.hpp"
#include "signal/frf_set/frf_set.hpp"
#include "updating/comparison/comparison.hpp"
#include "updating/fit/fitter.hpp"
#include "updating/measurement/mode_choices.hpp"

namespace tapfit::updating {

/// @param fit the model and its state
/// @param target measured FRFs on the comparison line
/// @param frfs measured FRFs as shown to the user; the model is evaluated on
///   their lines
/// @param modes identified modes, for pairing and MAC
/// @param by_hand pairs that stand whatever MAC and frequency say
[[nodiscard]] Comparison compare(const Fit& fit,
                                 const Target& target,
                                 const signal::FrfSet& frfs,
                                 const modal::ModeSet& modes,
                                 const std::vector<PairByHand>& by_hand = {});

/// The deck's form is one, whatever effects are in the model: of an error it
/// explains no more than where the most is explained.
/// @param form_error what it explains of the best model's error
void limit_form(Comparison& comparison, double form_error);

/// Whether a floor is so high that most of what may be missing is below it.
[[nodiscard]] bool hides_errors(double floor);

/// What is wrong with a floor so high that next to nothing can be told; empty
/// where it is not.
[[nodiscard]] std::string floor_warning(const Comparison& comparison);

}  // namespace tapfit::updating
