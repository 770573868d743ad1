// What --json prints.
#pragma once

#include <nlohmann/json_fwd.hpp>

#include <string>

namespace tapfit::tui {

/// The object as text with a line end. Bytes of a path that are no UTF-8, which
/// JSON cannot hold, become U+FFFD.
[[nodiscard]] std::string json_text(const nlohmann::ordered_json& object);

}  // namespace tapfit::tui
