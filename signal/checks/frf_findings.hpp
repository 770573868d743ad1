// What a measurement's own checks speak against, and what to do about it.
#pragma once

#include "acquisition/bundle/test_bundle.hpp"
#include "acquisition/foundation/finding.hpp"
#include "signal/checks/frf_checks.hpp"
#include "signal/checks/hit_coherence.hpp"

#include <string>
#include <vector>

namespace tapfit::signal {

/// The channel's name; of ready FRFs, which have none, where the sensor was.
[[nodiscard]] std::string channel_of(const acquisition::TestBundle& bundle,
                                     const Frf& frf);

/// "12Z+ / 3Z+ (acc1)".
[[nodiscard]] std::string titled(const acquisition::TestBundle& bundle,
                                 const Frf& frf);

/// The FRF's run, channel and points.
[[nodiscard]] Subject subject_of(const acquisition::TestBundle& bundle,
                                 const Frf& frf);

/// A hit or a sensor that agrees with the rest of its placement far less than
/// the others do among themselves: a column or a row of the coherence matrix.
///
/// @param of the runs of `group`
[[nodiscard]] std::vector<Finding> coherence_findings(
    const acquisition::TestBundle& bundle,
    const HitCoherence& of,
    const acquisition::RunGroup& group);

/// Driving points that no passive structure has: turned polarity, swapped
/// channels, another point.
[[nodiscard]] std::vector<Finding> driving_point_findings(
    const acquisition::TestBundle& bundle,
    const FrfSet& set,
    const std::vector<DrivingPoint>& points);

/// FRFs whose H2 lies more than 10 % over H1 at a peak; the worst is named.
[[nodiscard]] std::vector<Finding> spread_findings(const FrfSet& set);

}  // namespace tapfit::signal
