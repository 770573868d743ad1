// What a diagnosis comes to in a word, once its ladder stands.
#pragma once

#include "signal/frf_set/linearity_finding.hpp"
#include "updating/diagnosis/diagnosis.hpp"

#include <string>
#include <vector>

namespace tapfit::updating {

/// Whether what the FRFs change with the force is a good part of an error: then
/// no linear model comes much closer.
[[nodiscard]] bool follows_the_force(const signal::LinearityFinding& level,
                                     double error);

/// Names what the ladder holds, "none" or "unexplained".
///
/// Where the FRFs change with the force by a good part of what is left, no
/// linear model comes much closer: "nonlinearity" is part of the verdict then,
/// and the first candidate. Rungs that explain little more than that change are
/// its linear stand-ins; they are not named, but the first of them that is told
/// from all other grids tells its place.
///
/// @param level of the FRFs that the diagnosis was made on
/// @param held what else than the data holds the parameters:
/// active_constraints()
/// @param result with ladder, candidates and errors; gains the verdict, and
///   warnings where it is "unexplained"
void classify_diagnosis(const signal::LinearityFinding& level,
                        const std::vector<std::string>& held,
                        Diagnosis& result);

}  // namespace tapfit::updating
