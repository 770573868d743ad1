// Effects, their places and parameters, as JSON and as text.
#pragma once

#include "updating/diagnosis/diagnosis.hpp"

#include <nlohmann/json_fwd.hpp>

#include <string>
#include <vector>

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

/// "mass 0.07850 ± 0.00060 kg"; what the data do not tell from nothing, or
/// what ended at a bound, by the ends of its interval.
[[nodiscard]] std::string estimate_text(const updating::Estimate& estimate);

/// The same of all that are told, "A, B".
[[nodiscard]] std::string estimates_text(
    const std::vector<updating::Estimate>& estimates);

/// The error ladder: how far each added effect brought the error down. One rung
/// per line with a bar, the base first and the floor last:
///
///   base model                      38.8 %  ##############################
///   uncertain properties fitted     30.1 %  #######################
///   + added-mass at node 201         3.8 %  ###
///   floor                            3.1 %  ##
[[nodiscard]] std::string ladder_text(const updating::Diagnosis& diagnosis);

}  // namespace tapfit::tui
