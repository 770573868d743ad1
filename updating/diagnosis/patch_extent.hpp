// How large a patch is and how much it has lost are told apart by little: half
// of the stiffness of two elements is much like a third of four.
#pragma once

#include "updating/diagnosis/diagnosis.hpp"
#include "updating/fit/estimate.hpp"
#include "updating/search/hypotheses.hpp"

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

namespace tapfit::updating {

/// Over all patches that leave nothing to explain.
struct PatchExtent {
  std::size_t fewest = 0;  ///< elements
  std::size_t most = 0;
  double lo95 = 0.0;  ///< of the factor: of all their intervals
  double hi95 = 0.0;
};

/// Of the hypotheses those of the same effect that share elements with one and
/// leave no more than `explained`: below it the model itself may be wrong, and
/// which of them leaves less does not tell. Empty where there are no others.
///
/// @param explained the floor
[[nodiscard]] std::optional<PatchExtent> patch_extent(
    const std::vector<Hypothesis>& hypotheses,
    const EffectInstance& own,
    double explained,
    const effects::TestContext& context);

/// Widens the interval of a factor, and its deviation with it.
void widen(const PatchExtent& extent, Estimate& factor);

[[nodiscard]] std::string statement(const PatchExtent& extent);

}  // namespace tapfit::updating
