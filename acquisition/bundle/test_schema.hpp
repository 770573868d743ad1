// Checks a test.json against docs/test.schema.json (JSON Schema draft-07).
#pragma once

#include <nlohmann/json_fwd.hpp>

#include <string>
#include <string_view>
#include <vector>

namespace tapfit::acquisition {

/// The text of docs/test.schema.json, compiled into the program.
[[nodiscard]] std::string_view test_schema();

/// Validates a document against the schema.
///
/// The remedy of an error is the `description` that the schema gives for the
/// place that is wrong.
///
/// @param source named in front of the place: "test.json: runs[2].file"
/// @throws InputError for the first thing that does not fit
void check_against_schema(const nlohmann::json& document,
                          const std::string& source);

/// The places of all fields that the schema does not know: "runs[0].colour".
[[nodiscard]] std::vector<std::string> unknown_fields(
    const nlohmann::json& document);

}  // namespace tapfit::acquisition
