// One channel of a test's recordings.
#pragma once

#include "acquisition/foundation/units.hpp"

#include <optional>
#include <string>

namespace tapfit::acquisition {

/// One recorded channel.
/// physical value [SI] = sample * full_scale_volts / sensitivity * unit factor
struct Channel {
  std::string name;
  Quantity quantity = Quantity::Acceleration;
  std::string unit;               ///< as written, for example "g" or "m/s^2"
  double unit_to_si = 1.0;        ///< SI value of one `unit`
  double sensitivity = 1.0;       ///< volts per `unit`
  double full_scale_volts = 1.0;  ///< volts at a sample of 1.0
  std::optional<double> mass_kg;  ///< maker's sheet; not in the base model
  double height_m = 0.0;          ///< of the sensing element above the surface

  /// SI value of digital full scale (a sample of 1.0).
  [[nodiscard]] double full_scale_si() const {
    return full_scale_volts / sensitivity * unit_to_si;
  }
};

}  // namespace tapfit::acquisition
