// Effects, their places and parameters, as JSON and as text.
#pragma once

#include "updating/diagnosis/diagnosis.hpp"

#include <nlohmann/json_fwd.hpp>

namespace tapfit::tui {

/// The place as the effect's row of the format's table names it: {"node": 201},
/// {"channels": ["acc1"]}, {"channel": "acc1"}, {"nodes": [..]},
/// {"elements": [..]} or {}.
///
/// @param effect catalogue name; of a group "a|b" the first counts
[[nodiscard]] nlohmann::ordered_json where_json(
    const std::string& effect, const updating::Location& where);

/// {KEY: effect, "where": {..}} and, where the effect has several forms at a
/// place, "variant": "rotation".
[[nodiscard]] nlohmann::ordered_json placed_json(
    const char* key,
    const std::string& effect,
    const updating::Location& where);

/// {"value", "sd", "lo95", "hi95"}, and "unit" where the name has none.
[[nodiscard]] nlohmann::ordered_json estimate_json(
    const updating::Estimate& estimate);

/// {"mass_kg": {"value", "sd", "lo95", "hi95"}}
[[nodiscard]] nlohmann::ordered_json parameters_json(
    const std::vector<updating::Estimate>& parameters);

/// {"E:1": {"value", "sd", "unit"}}
[[nodiscard]] nlohmann::ordered_json model_parameters_json(
    const std::vector<updating::Estimate>& parameters);

}  // namespace tapfit::tui
