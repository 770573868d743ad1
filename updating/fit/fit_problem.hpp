// From a test's recordings to what fits work on: targets on damped lines,
// typical damping, and the properties that are fitted along.
#pragma once

#include "modal/mode_set/mode_set.hpp"
#include "updating/effects/suspension.hpp"
#include "updating/fit/estimates.hpp"
#include "updating/fit/fitter.hpp"
#include "updating/measurement/measurement.hpp"

#include <memory>

namespace tapfit::updating {

/// What was measured, as fits need it.
struct MeasuredTest {
  effects::TestContext context;
  const Measurement& measurement;  ///< up to its modes
  const signal::FrfSet& frfs;      ///< its FRFs as they are
  const modal::ModeSet& modes;
};

/// Runs of another structure are not in use. Of a structure that the model
/// leaves free lines below the first elastic mode are left out: how it hangs is
/// not in the model.
[[nodiscard]] FitProblem fit_problem(const MeasuredTest& test,
                                     const BaseBuilder& builder,
                                     const Progress& progress);

/// How a free structure hangs: as low as test.json says (suspension_hz), or,
/// where modes were measured, as is usual. Measured rigid-body modes tell by
/// themselves, and so do FRFs, which have their mass line.
/// @param modes as measured, ascending
/// @return null where the model is held, or nothing is known
[[nodiscard]] std::shared_ptr<const effects::Suspension> suspension_of(
    const acquisition::TestBundle& bundle,
    const modal::ModeSet& modes,
    const BaseBuilder& builder);

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
