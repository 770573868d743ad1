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

/// A deck as the engineer has it, and another of the same structure that is
/// wrong in form nowhere. What weakens elements is to be made in that one.
/// @param truth with each of the engineer's grids among its own: of solid
///   elements, say, where those are of a plate's middle
/// @throws InputError for a grid that is missing there or stands elsewhere
[[nodiscard]] VirtualModel with_truth(const structure::Deck& deck,
                                      const structure::Deck& truth);

}  // namespace tapfit::updating
