// Modes before and after the model was updated.
#pragma once

#include "updating/comparison/comparison.hpp"

#include <string>

namespace tapfit::tui {

/// Measured frequency against the model's before and after, MAC before and
/// after, as a Markdown table; one row per measured mode that either model
/// pairs.
[[nodiscard]] std::string before_after_table(const updating::Comparison& before,
                                             const updating::Comparison& after);

}  // namespace tapfit::tui
