// tapfit diagnose: what is missing from the model.
#pragma once

#include "updating/diagnosis/diagnosis.hpp"

#include <nlohmann/json_fwd.hpp>

#include <filesystem>
#include <string>

namespace tapfit::tui {

/// {"bundle", "verdict", "error", "candidates", "ladder", "model_parameters",
/// "warnings"}
[[nodiscard]] nlohmann::ordered_json diagnosis_json(
    const std::filesystem::path& bundle, const updating::Diagnosis& diagnosis);

/// Verdict, ranked candidates, what the base's parameters became, warnings and
/// last the error ladder.
[[nodiscard]] std::string diagnosis_text(const updating::Diagnosis& diagnosis);
/// The same without the verdict.
[[nodiscard]] std::string findings_text(const updating::Diagnosis& diagnosis);

}  // namespace tapfit::tui
