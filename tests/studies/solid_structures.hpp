// The plates and frames of the study of solid truths.
#pragma once

#include "tests/studies/solid_plate.hpp"

#include <vector>

namespace tapfit::updating::testing {

/// Six plates, a fold, a channel and three frames.
[[nodiscard]] std::vector<SolidPlate> solid_structures();

}  // namespace tapfit::updating::testing
