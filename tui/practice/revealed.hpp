// What a challenge hid, beside what was found of it, as text and as JSON.
#pragma once

#include "updating/diagnosis/diagnosis.hpp"
#include "updating/practice/score_diagnosis.hpp"

#include <nlohmann/json.hpp>

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace tapfit::tui {

/// What somebody, or the program, found, and what it is worth.
struct Answer {
  std::vector<updating::Rung> effects;
  updating::DiagnosisScore verdict;
};

struct Revealed {
  nlohmann::ordered_json truth;   ///< as it was sealed
  std::optional<Answer> session;  ///< nothing: no effect was added yet
  Answer diagnosis;
};

/// See docs/practice.md.
[[nodiscard]] nlohmann::ordered_json revealed_json(
    const std::filesystem::path& bundle, const Revealed& it);

[[nodiscard]] std::string revealed_text(const std::filesystem::path& bundle,
                                        const Revealed& it);

}  // namespace tapfit::tui
