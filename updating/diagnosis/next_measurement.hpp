// Where to measure next when two explanations fit the data alike: the hit or
// sensor point at which the FRFs that they predict differ most.
#pragma once

#include "updating/diagnosis/diagnosis.hpp"
#include "updating/fit/fitter.hpp"

#include <optional>

namespace tapfit::updating {

/// Tries grids, evenly chosen where they are more than 120, as further hit
/// points and as new places of each sensor, its mass moving along. Both fits
/// predict the new FRFs with the parameters they have; the difference is in
/// units of the line's mean level, as the relative error is, and so compares
/// with the floor.
///
/// @param a, b fits of one test that explain it alike, the last effect of each
///   being what they disagree about
/// @return empty for a test without sensors
[[nodiscard]] std::optional<NextMeasurement> next_measurement(
    const Fit& a, const Fit& b, const Fitter& fitter);

}  // namespace tapfit::updating
