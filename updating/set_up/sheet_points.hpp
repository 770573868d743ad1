// The points of a sheet at which it may be wrong: what channels it has at which
// grid, in which runs.
#pragma once

#include "updating/effects/effect.hpp"
#include "updating/places/location.hpp"

#include <functional>
#include <string>
#include <vector>

namespace tapfit::effects {

/// Each channel at each of its grids (Where::channels, Where::nodes), hammers
/// first, and sensors that sit at one grid together (a triaxial one) as one.
[[nodiscard]] std::vector<Location> written_points(const TestContext& context);

/// The runs in which the sheet has something there, counted from 1. Runs of one
/// placement are averaged, so that a mistake is in all of them: they are one
/// list, ascending; lists are in the order of their first runs.
[[nodiscard]] std::vector<std::vector<int>> averaged_runs(
    const Location& where, const acquisition::TestBundle& sheet);

/// Why a mistake cannot be in the runs of a place: there is no such run, or
/// only some of an average are named. Empty where it can.
[[nodiscard]] std::string fault_of_runs(const Location& where,
                                        const acquisition::TestBundle& sheet);

/// A sensor's point again for the averages from each of its own on, and for
/// those before each: it was moved, and the sheet does not say so. Empty for a
/// hammer, which is moved by hand from blow to blow.
[[nodiscard]] std::vector<Location> parted_by_runs(
    const Location& point, const acquisition::TestBundle& sheet);

/// Calls for every placement of a sheet that a place means: those of its
/// channels, at its grid where it has one, in its runs.
///
/// @param written by which it is told what is meant
/// @param sheet of the same runs; what is handed over
void for_each_meant(const Location& where,
                    const acquisition::TestBundle& written,
                    acquisition::TestBundle& sheet,
                    const std::function<void(acquisition::Placement&)>& change);

/// Whether the place's channels are those of hammers.
[[nodiscard]] bool is_hammer(const Location& where,
                             const acquisition::TestBundle& sheet);

}  // namespace tapfit::effects
