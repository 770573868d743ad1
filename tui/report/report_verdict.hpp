// The result in one sentence.
#pragma once

#include "tui/report/report_data.hpp"

#include <string>
#include <vector>

namespace tapfit::tui {

[[nodiscard]] std::string verdict_sentence(const ReportData& data);

/// The ladder's rungs that are effects.
[[nodiscard]] std::vector<updating::Rung> effect_rungs(
    const std::vector<updating::Rung>& ladder);

/// What the diagnosis says of a rung, where it found the same one.
[[nodiscard]] const updating::Rung* diagnosed_rung(const ModelResults& model,
                                                   const updating::Rung& rung);

/// Whether the model has just what the diagnosis found: then what that says of
/// all of it together holds.
[[nodiscard]] bool is_diagnosed(const ModelResults& model);

}  // namespace tapfit::tui
