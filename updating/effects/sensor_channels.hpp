// Channels that sensors are on, and where they sit in a run.
#pragma once

#include "updating/effects/effect.hpp"
#include "updating/places/location.hpp"

#include <string>
#include <vector>

namespace tapfit::effects {

/// All sensor channels together, then each alone where there are several.
[[nodiscard]] std::vector<Where> sensor_places(const Setting& setting);

/// A sensor of the run on one of the channels of `where`.
struct PlacedSensor {
  Dof dof;
  std::size_t position = 0;  ///< index into Where::channels
};

[[nodiscard]] std::vector<PlacedSensor> placed_sensors(const Where& where,
                                                       const Setting& setting,
                                                       std::size_t run);

}  // namespace tapfit::effects
