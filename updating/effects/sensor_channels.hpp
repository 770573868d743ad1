// Channels that sensors and hammers are on, and where sensors sit in a run.
#pragma once

#include "updating/effects/effect.hpp"
#include "updating/places/location.hpp"

#include <string>
#include <vector>

namespace tapfit::effects {

/// All sensor channels together, then each alone where there are several.
[[nodiscard]] std::vector<Location> sensor_places(const TestContext& context);

/// Each hammer channel alone.
[[nodiscard]] std::vector<Location> hammer_places(const TestContext& context);

/// Each sensor channel, then each hammer channel.
[[nodiscard]] std::vector<Location> channel_places(const TestContext& context);

/// A sensor of the run on one of the channels of `where`.
struct PlacedSensor {
  Dof dof;
  std::size_t position = 0;  ///< index into Where::channels
};

/// The grid that cards for a sensor go to: its own, or of a point of the test's
/// own the nearest.
[[nodiscard]] int card_grid(const structure::Deck& deck, int node);

/// The component of that grid that such cards act on: of a point of the test's
/// own the basic axis that its component is closest to.
[[nodiscard]] int card_axis(const structure::Deck& deck, const Dof& dof);

/// A line that says so, for a point of the test's own; else none.
[[nodiscard]] std::vector<std::string> card_note(const structure::Deck& deck,
                                                 int node);

/// One that says what card_axis leaves out, for a component that is along no
/// basic axis; else none.
[[nodiscard]] std::vector<std::string> axis_note(const structure::Deck& deck,
                                                 const Dof& dof);

[[nodiscard]] std::vector<PlacedSensor> placed_sensors(
    const Location& where, const TestContext& context, std::size_t run);

}  // namespace tapfit::effects
