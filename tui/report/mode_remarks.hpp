// What there is to say of modes that do not fit though the FRFs do.
#pragma once

#include "updating/comparison/comparison.hpp"

#include <string>
#include <vector>

namespace tapfit::tui {

/// Why pairs are off in MAC or frequency where the error is at its floor: modes
/// closer than their shapes can be told apart, and others, which the damped
/// lines that the error is taken on look past. Empty where nothing is off, or
/// where the error itself is.
[[nodiscard]] std::vector<std::string> mode_remarks(
    const updating::Comparison& comparison);

}  // namespace tapfit::tui
