// The effects of this room, each in the file of its name, and how they show.
#pragma once

#include "updating/effects/effect.hpp"

namespace tapfit::effects {

/// The accelerometers' mass: lowers frequencies, moves with a roving sensor.
[[nodiscard]] const Effect& sensor_mass();
/// A support that gives: lowers the first modes most, where the support carries
/// them.
[[nodiscard]] const Effect& soft_support();
/// A mass at one grid: lowers frequencies, grows with frequency squared, the
/// same in every run.
[[nodiscard]] const Effect& added_mass();
/// A spring from one grid to ground: raises frequencies, the same stiffness at
/// every frequency.
[[nodiscard]] const Effect& ground_spring();
/// A damper from one grid to ground: widens peaks where the grid moves, leaves
/// frequencies.
[[nodiscard]] const Effect& dashpot();
/// The accelerometers' cables: stiffen and damp the lowest modes a little where
/// the sensors sit.
[[nodiscard]] const Effect& sensor_cable();
/// Elements with less stiffness: lowers the modes that strain them, in
/// proportion to the strain energy there.
[[nodiscard]] const Effect& stiffness_loss();
/// A seam that turns: lowers the modes that bend across it, leaves those that
/// do not.
[[nodiscard]] const Effect& joint();
/// A member under axial force: pulled it raises the lowest modes most, pushed
/// it lowers them.
[[nodiscard]] const Effect& prestress();
/// A mass on a spring at one grid: splits the modes near its own frequency.
[[nodiscard]] const Effect& absorber();
/// The damping of all modes by one law.
[[nodiscard]] const Effect& damping_law();

}  // namespace tapfit::effects
