// JSON that someone may have written by hand.
#pragma once

#include <nlohmann/json_fwd.hpp>

#include <string>

namespace tapfit {

/// @param source the file's name, for the error
/// @throws InputError with line and column of what is no JSON
[[nodiscard]] nlohmann::json parse_json(const std::string& text,
                                        const std::string& source);

}  // namespace tapfit
