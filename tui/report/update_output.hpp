// How an update's fits came about, as JSON for plotting and as text.
#pragma once

#include "updating/fit/update_record.hpp"

#include <nlohmann/json_fwd.hpp>

#include <string>
#include <vector>

namespace tapfit::tui {

/// One object per fit: "added", "where", "lines", "converged", "message",
/// "parameters", "iterations", "l_curve" (null by default), "identifiability",
/// "correlation"; see docs/commands.md.
[[nodiscard]] nlohmann::ordered_json updates_json(
    const std::vector<updating::UpdateRecord>& records);

/// A line per fit, then of the last one what the data cannot tell apart, the
/// correlations of its parameters and the L-curve with its corner.
[[nodiscard]] std::string updates_text(
    const std::vector<updating::UpdateRecord>& records);

}  // namespace tapfit::tui
