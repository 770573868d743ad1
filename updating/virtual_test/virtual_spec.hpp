// What a virtual test is to be made of.
#pragma once

#include "updating/virtual_test/virtual_effect.hpp"

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace tapfit::updating {

struct VirtualBundleSpec {
  std::string structure = "frame";  ///< one of virtual_structures(), or a deck
  std::string truth;  ///< deck of what it really is; empty: the same, finer
  std::vector<VirtualEffect> effects;
  bool roving_sensor = false;  ///< else the hammer roves
  std::uint64_t seed = 1;
  int points = 24;                               ///< that are roved over
  int hits = 5;                                  ///< of each run
  std::optional<std::array<double, 2>> band_hz;  ///< needed for a deck
  std::optional<double> gap_s;                   ///< between hits
  std::optional<double> modulus_percent;         ///< E off; else seeded, sd 2 %
  std::optional<double> stated_mass_kg;  ///< of each sensor, in `channels`
  double damping_mean = 0.006;
  bool faulty_hits = true;  ///< one double hit and one overload
  double noise = 1.0;       ///< times that of an ordinary front end
  bool sealed = false;      ///< what is hidden is not to be read by accident
};

}  // namespace tapfit::updating
