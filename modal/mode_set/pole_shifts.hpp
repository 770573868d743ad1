// What poles that differ between set-ups of the sensors have to say; found by
// modal/mass_loading/explain_shifts.hpp.
#pragma once

#include <cstddef>
#include <vector>

namespace tapfit::modal {

enum class ShiftCause {
  Noise,         ///< nothing to tell
  SensorMass,    ///< in proportion to the squared shape at the sensors
  SameFraction,  ///< all modes of a set-up by the same fraction
  Unknown        ///< more than noise, but like neither
};

struct MassEstimate {
  double kg = 0.0;
  double sd_kg = 0.0;
  double lo95_kg = 0.0;
  double hi95_kg = 0.0;
};

struct PoleShifts {
  ShiftCause cause = ShiftCause::Noise;
  double largest = 0.0;          ///< (highest - lowest) / mean of any mode
  double p_mass = 1.0;           ///< of so good a fit of the masses by chance
  double p_same_fraction = 1.0;  ///< the same of c_k
  double p_noise = 1.0;          ///< of the shifts, by the poles' own sd
  double explained = 0.0;        ///< by the cause, of the squared shifts, 0..1
  double same_fraction = 0.0;    ///< rms of c_k where significant, else 0
  /// One for all sensors, or one per sensor where they differ significantly;
  /// none unless the cause is SensorMass, the shapes are scaled, and the masses
  /// explain most of the shifts.
  std::vector<MassEstimate> masses;
  /// Channels of each sensor, in the order of ShiftData::phi.
  std::vector<std::vector<std::size_t>> sensors;
};

}  // namespace tapfit::modal
