// The poles' shifts between set-ups set beside the shapes at the sensors.
#pragma once

#include "modal/fit/shapes.hpp"
#include "modal/mass_loading/multi_setup_identification.hpp"
#include "modal/mode_set/pole_shifts.hpp"
#include "modal/poles/weighted_frfs.hpp"

#include <optional>
#include <string>
#include <vector>

namespace tapfit::modal {

/// Tells why the poles differ between set-ups.
///
/// Channels that sit at one grid in some set-up are one sensor with one mass.
/// Only the directions that are measured count: of a sensor with one axis, the
/// mass across it is not seen.
///
/// @param frfs the set that the curves were made of
/// @return empty when there is too little to tell, or the shapes do not hold
///   the sensors' points
[[nodiscard]] std::optional<PoleShifts> sensor_shifts(
    const signal::FrfSet& frfs,
    const WeightedFrfs& curves,
    const ShapeGraph& graph,
    const MultiSetupModes& runs);

/// Whether there are shifts and they are more than noise.
[[nodiscard]] bool is_significant(const std::optional<PoleShifts>& shifts);

/// What the shifts say, in a sentence; empty when they are noise.
///
/// @param channels names, by index; numbers are given where there are none
[[nodiscard]] std::string statement(const PoleShifts& shifts,
                                    const std::vector<std::string>& channels);

}  // namespace tapfit::modal
