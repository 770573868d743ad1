// A free plate of unknown material, recorded virtually and identified from one
// hammer test: hit at one corner, felt at another.
#pragma once

#include "updating/diagnosis/diagnosis.hpp"

#include <array>
#include <cstdint>
#include <map>
#include <string>
#include <vector>

namespace tapfit::support {

/// 0.58 m x 0.22 m x 4.7 mm: a guitar's top before it is carved, of the
/// material card given, in half as many shells across as along.
[[nodiscard]] std::string free_plate_deck(const std::string& material,
                                          int along);

struct PlateTest {
  std::string truth;                    ///< MAT1 or MAT8 card
  std::string deck;                     ///< the engineer's
  std::vector<std::string> properties;  ///< uncertain, prior sd 15 %
  std::uint64_t seed = 1;
  double sensor_kg = 0.0;  ///< built in and identified, where above zero
  std::array<double, 2> band_hz{50.0, 600.0};
  int shells_along = 16;  ///< the engineer's; the truth has four times as many
};

/// What is found, by name ("E1:1", "sensor-mass mass_kg"). The runs whose
/// hammer and sensor are on different corners are used; where the sensors weigh
/// something, both sensors are.
[[nodiscard]] std::map<std::string, updating::Estimate> identify_plate(
    const PlateTest& test);

}  // namespace tapfit::support
