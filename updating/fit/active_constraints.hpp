// What else than the data holds a fit where it ended: a narrow prior, a bound.
// An error that is left may be theirs.
#pragma once

#include "updating/fit/estimate.hpp"
#include "updating/fit/estimates.hpp"

#include <string>
#include <vector>

namespace tapfit::updating {

/// @param properties the uncertain ones, as property_names() gives them
/// @param parameters everything that was fitted: all_estimates()
/// @return one clause for each property two standard deviations of its prior
///   or more from the deck's value, and each parameter at a bound
[[nodiscard]] std::vector<std::string> active_constraints(
    const std::vector<PropertyName>& properties,
    const std::vector<Estimate>& parameters);

/// What an error far above the floor comes from: "something else is missing",
/// behind what holds the fit, which may be all there is to it.
[[nodiscard]] std::string what_is_left(const std::vector<std::string>& held);

}  // namespace tapfit::updating
