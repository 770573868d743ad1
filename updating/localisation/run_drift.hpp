// Whether the structure's stiffness changed while it was tested, run after run:
// a room that warms up, a clamp that works loose. No effect of the catalogue
// does, and the mean over the runs hides it.
//
// What a fit leaves is set against its slope by the moduli, J, and by moduli
// that change evenly over the runs, t J with t from -1/2 to 1/2:
//
//   r = a J + b (t J) + rest
//
// b is the change of ln(stiffness) from the first run to the last.
#pragma once

#include "updating/fit/fitter.hpp"

#include <optional>
#include <string>

namespace tapfit::updating {

struct RunDrift {
  double change = 0.0;     ///< of ln stiffness, from the first run to the last
  double sd = 0.0;         ///< its standard deviation
  double explained = 0.0;  ///< share of what the fit leaves, in power
};

/// @param target that the fit's residual belongs to
/// @return empty where no modulus is uncertain, where the sensors move between
///   runs (then something else changes with them) and for fewer than four runs
[[nodiscard]] std::optional<RunDrift> run_drift(const Fit& fit,
                                                const Target& target);

/// Half of what is left or more, five standard deviations from nothing: then
/// something surely changed.
[[nodiscard]] bool is_significant(const RunDrift& drift);

[[nodiscard]] std::string statement(const RunDrift& drift);

}  // namespace tapfit::updating
