// The deck's mass against that of the scale.
#pragma once

#include "acquisition/bundle/test_bundle.hpp"
#include "acquisition/foundation/finding.hpp"

#include <optional>

namespace tapfit::updating {

/// A warning where they differ by more than screws, glue and paint weigh (5 %),
/// and by three standard deviations of the scale and of what is uncertain of
/// the deck's densities, thicknesses and areas.
///
/// @param deck_kg without what is identified; not above zero: not known
/// @return empty where the structure was not weighed
[[nodiscard]] std::optional<Finding> weighed_mass_finding(
    const acquisition::TestBundle& bundle, double deck_kg);

}  // namespace tapfit::updating
