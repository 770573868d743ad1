// Sizes of an effect that are tried before a fit: evenly spread over all that
// they may be.
#pragma once

#include "updating/effects/effect.hpp"

#include <vector>

namespace tapfit::updating {

/// Every combination of a few sizes of each parameter, each evenly spread in
/// the logarithm between its bounds.
/// @return parameters of each combination
[[nodiscard]] std::vector<std::vector<double>> size_grid(
    const std::vector<effects::ParameterSpec>& specs,
    const std::vector<int>& counts);

/// The same with as many of each as tell its best sizes roughly. A resonance is
/// narrow: its frequency, the second of three, is scanned more closely than
/// sizes and damping.
[[nodiscard]] std::vector<std::vector<double>> size_grid(
    const std::vector<effects::ParameterSpec>& specs);

}  // namespace tapfit::updating
