// From a test's recordings to what fits work on: targets on damped lines,
// typical damping, and the properties that are fitted along.
#pragma once

#include "modal/mode_set/mode_set.hpp"
#include "updating/fit/estimates.hpp"
#include "updating/fit/fitter.hpp"
#include "updating/measurement/measurement.hpp"

namespace tapfit::updating {

/// What was measured, as fits need it.
struct MeasuredTest {
  effects::Setting setting;
  const Measurement& measurement;  ///< up to its modes
  const modal::ModeSet& modes;
};

/// @param free_structure lines below the first elastic mode are left out: how
///   the structure hangs is not in the model
[[nodiscard]] FitSetting fit_setting(const MeasuredTest& test,
                                     bool free_structure,
                                     const Progress& progress);

/// Names, units and nominal values of the bundle's uncertain properties.
[[nodiscard]] std::vector<PropertyName> property_names(
    const acquisition::TestBundle& bundle, const structure::Deck& deck);

/// The basic direction, 1..3, that most sensors measure, or nearly; of
/// frequencies alone that across which the structure is thinnest.
[[nodiscard]] int measured_component(const acquisition::TestBundle& bundle,
                                     const structure::Deck& deck);

/// 1..3, ascending: every direction in which something was measured or hit.
[[nodiscard]] std::vector<int> tested_components(
    const acquisition::TestBundle& bundle, const structure::Deck& deck);

}  // namespace tapfit::updating
