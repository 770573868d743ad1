// Whether one law holds the damping of all modes as well as a ratio for each.
#pragma once

#include "updating/fitter.hpp"

#include <optional>
#include <string>

namespace tapfit::updating {

/// A sentence with the law, where its evidence is the stronger; nothing for a
/// fit of so few modes that the law has as many parameters, or that has a law.
///
/// @param data independent data, see evidence_data()
[[nodiscard]] std::optional<std::string> damping_statement(
    const Fit& fit,
    const Fitter& fitter,
    double data,
    const Progress& progress);

}  // namespace tapfit::updating
