// What scales are held against: the mass of a free body, by its mass lines or
// by an operational calibration (signal/checks/calibration.hpp).
#pragma once

#include "signal/checks/calibration.hpp"
#include "signal/checks/frf_findings.hpp"

namespace tapfit::signal {

/// Mass lines against the mass of a free body: no point of it can seem heavier
/// than the whole.
///
/// @param mass_kg of the body with its sensors, above zero
/// @param share that a mass line may exceed it by
[[nodiscard]] std::vector<Finding> mass_line_findings(
    const acquisition::TestBundle& bundle,
    const FrfSet& set,
    const std::vector<DrivingPoint>& points,
    double mass_kg,
    double share = 0.02);

/// What a calibration asks for: sensitivities to enter, a delay, a polarity, or
/// a band in which the body is a mass. Empty for a fair chain: gain within half
/// a per cent or two of its standard deviations of 1, delay within two of 0 or
/// 3 degrees at the highest line.
[[nodiscard]] std::vector<Finding> calibration_findings(
    const acquisition::TestBundle& bundle,
    const FrfSet& set,
    const std::vector<Calibration>& found);

}  // namespace tapfit::signal
