// The points of a sheet at which it may be wrong: what channels it has at which
// grid, in which runs.
#pragma once

#include "updating/effects/effect.hpp"
#include "updating/places/location.hpp"

#include <functional>
#include <vector>

namespace tapfit::effects {

/// Each channel at each of its grids (Where::channels, Where::nodes), hammers
/// first, and sensors that sit at one grid together (a triaxial one) as one.
[[nodiscard]] std::vector<Where> written_points(const Setting& setting);

/// A sensor's point again for the runs from each of its runs on, and for those
/// up to each: it was moved, and the sheet does not say so. Empty for a hammer,
/// which is moved by hand from blow to blow.
[[nodiscard]] std::vector<Where> parted_by_runs(
    const Where& point, const acquisition::TestBundle& sheet);

/// Calls for every placement of a sheet that a place means: those of its
/// channels, at its grid where it has one, in its runs.
///
/// @param written by which it is told what is meant
/// @param sheet of the same runs; what is handed over
void for_each_meant(const Where& where,
                    const acquisition::TestBundle& written,
                    acquisition::TestBundle& sheet,
                    const std::function<void(acquisition::Placement&)>& change);

/// Indices of the runs in which the sheet has something there.
[[nodiscard]] std::vector<std::size_t> runs_meant(
    const Where& where, const acquisition::TestBundle& sheet);

/// Whether the place's channels are those of hammers.
[[nodiscard]] bool is_hammer(const Where& where,
                             const acquisition::TestBundle& sheet);

}  // namespace tapfit::effects
