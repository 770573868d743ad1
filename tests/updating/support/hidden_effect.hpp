// A physical effect hidden in a structure given by its modes: what a diagnosis
// looks for, and what the check of a test must not take for a mistake.
//
//   (diag(w^2) + dK) q = w'^2 (I + dM) q,   phi' = q' phi
//
// in the coordinates of the modes, so that what comes out is a structure again.
// Damping is what the modes had, mode by mode.
#pragma once

#include "tests/signal/support/generated_structure.hpp"

#include <cstddef>

namespace tapfit::updating::testing {

enum class Hidden {
  None,
  PointMass,     ///< at one point, weighed with the structure
  SensorMasses,  ///< of each sensor at its point, not on the sheet
  GroundSpring,  ///< from one point
  Softened       ///< less stiffness against bending at one point
};

struct HiddenEffect {
  Hidden kind = Hidden::None;
  double size = 0.5;      ///< 0 just visible ... 1 gross
  std::size_t point = 6;  ///< of those that act at one
};

/// Of the effect's masses [kg]; 0 for the others.
[[nodiscard]] double mass_of(const HiddenEffect& effect, double mass_kg);

/// @param bare freely hung or held, its sensors in place
/// @param mass_kg of the bare structure
[[nodiscard]] signal::HungStructure with_effect(
    const signal::HungStructure& bare,
    const HiddenEffect& effect,
    double mass_kg);

}  // namespace tapfit::updating::testing
