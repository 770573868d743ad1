// A prediction as text and as JSON, and whether a second test confirms it.
#pragma once

#include "updating/prediction/confirmation.hpp"
#include "updating/prediction/prediction.hpp"

#include <nlohmann/json_fwd.hpp>

#include <string>

namespace tapfit::tui {

/// {"with", "change", "form_sd", "modes", "frfs", "warnings"}; see
/// docs/commands.md.
[[nodiscard]] nlohmann::ordered_json prediction_json(
    const updating::Prediction& prediction);

/// {"finding", "statement", "limit", "modes", "unseen"}.
[[nodiscard]] nlohmann::ordered_json confirmation_json(
    const updating::Confirmation& confirmation,
    const updating::Prediction& prediction);

/// The model, the change, a table of modes, what FRFs change by, notes.
/// @param source where the model's effects are from
[[nodiscard]] std::string prediction_text(
    const updating::Prediction& prediction, const std::string& source);

/// A table of the modes seen, then the statement.
[[nodiscard]] std::string confirmation_text(
    const updating::Confirmation& confirmation,
    const updating::Prediction& prediction);

}  // namespace tapfit::tui
