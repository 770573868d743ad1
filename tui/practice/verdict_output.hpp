// How a verdict on what was hidden is told: as JSON, and as a row of a table.
#pragma once

#include "updating/practice/score_diagnosis.hpp"

#include <nlohmann/json_fwd.hpp>

#include <string>
#include <vector>

namespace tapfit::tui {

/// {"hidden", "found", "right_kind", "honest", "right_place", "right_size",
/// "size_error", "error", "floor", "intervals", "intervals_hold"}
[[nodiscard]] nlohmann::ordered_json verdict_json(
    const updating::DiagnosisScore& verdict);

/// Effect, place, size, error and floor in a word each; place and size are not
/// judged where the effect is another one, or none.
[[nodiscard]] std::vector<std::string> verdict_row(
    const updating::DiagnosisScore& verdict);

}  // namespace tapfit::tui
