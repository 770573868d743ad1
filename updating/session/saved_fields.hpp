// Fields of the session's file, which people may write by hand: what is
// misspelt must not be lost without a word.
#pragma once

// Its exceptions then say where in the file; to be included before any other
// file that includes it.
#define JSON_DIAGNOSTICS 1
#include <nlohmann/json.hpp>

#include <initializer_list>

namespace tapfit::updating::saved {

/// Counted from 1 in the file, from 0 here.
/// @throws std::out_of_range for what is no such number
[[nodiscard]] int index_from(const nlohmann::ordered_json& value,
                             const char* counted);

/// @throws std::out_of_range for a field that is not known
void check_fields(const nlohmann::ordered_json& value,
                  const char* what,
                  std::initializer_list<const char*> known);

/// The list of that name; empty where it is not there.
/// @throws std::out_of_range for what is no list
[[nodiscard]] const nlohmann::ordered_json& list_in(
    const nlohmann::ordered_json& value, const char* name);

}  // namespace tapfit::updating::saved
