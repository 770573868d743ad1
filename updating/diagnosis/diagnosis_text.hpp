// A diagnosis as a text that gives it back to the last bit.
#pragma once

#include "updating/diagnosis/diagnosis.hpp"

#include <optional>
#include <string>
#include <string_view>

namespace tapfit::updating {

/// All of it, as JSON.
/// @return none where a name in it is no UTF-8
[[nodiscard]] std::optional<std::string> as_text(const Diagnosis& diagnosis);

/// @return none for a text that is not as as_text() writes it, or with a number
///   that is none
[[nodiscard]] std::optional<Diagnosis> diagnosis_from(std::string_view text);

}  // namespace tapfit::updating
