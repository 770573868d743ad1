// How firm a verdict is, as text and JSON: what was changed, what becomes of
// the verdict, how far the sizes move.
#pragma once

#include "updating/diagnosis/diagnosis.hpp"

#include <nlohmann/json_fwd.hpp>

#include <string>
#include <vector>

namespace tapfit::tui {

using RobustnessRows = std::vector<updating::Robustness>;

/// "the verdict stands under 15 of 17 changes; sizes move by up to 0.4 standard
/// deviations (run 3 left out)"
/// @param rows not empty
[[nodiscard]] std::string firmness_words(const RobustnessRows& rows);

/// "stands", or what the verdict is then.
[[nodiscard]] std::string verdict_then(const updating::Robustness& row);

/// "0.41 sd"; empty where nothing has a size.
[[nodiscard]] std::string move_text(const updating::Robustness& row);

/// The table's lines, the heading first.
[[nodiscard]] std::vector<std::string> robustness_table(
    const RobustnessRows& rows);

/// The sentence, below it a table with a line for each change.
[[nodiscard]] std::string robustness_text(const RobustnessRows& rows);

/// [{"change", "verdict", "verdict_stands", "largest_move_sd", "parameters"}]
[[nodiscard]] nlohmann::ordered_json robustness_json(
    const RobustnessRows& rows);

}  // namespace tapfit::tui
