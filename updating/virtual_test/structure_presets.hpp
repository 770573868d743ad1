// The structures that the virtual test knows by name, with what is usual for
// each of them: band, hammer, sensors, how much finer the truth is.
#pragma once

#include "updating/virtual_test/virtual_structure.hpp"

#include <Eigen/Core>

#include <array>
#include <optional>
#include <string>
#include <vector>

namespace tapfit::updating {

struct StructurePreset {
  std::string title;
  VirtualModel model;
  std::vector<std::string> cards;  ///< of the engineer's model, bulk data
  std::array<double, 2> band_hz{};
  double peak_n = 0.0;                   ///< of an ordinary hit [N]
  std::vector<Eigen::Vector3d> sensors;  ///< where they are [m]; empty: chosen
};

/// Names of the structures, in the order in which they are listed to users.
[[nodiscard]] const std::vector<std::string>& virtual_structures();

/// @return empty for a name that is none of virtual_structures()
[[nodiscard]] std::optional<StructurePreset> preset_of(
    const std::string& structure);

/// A deck as the engineer has it, and with every element split twice.
[[nodiscard]] VirtualModel split_twice(const structure::Deck& deck);

}  // namespace tapfit::updating
