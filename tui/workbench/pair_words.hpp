// Which mode is which, as it is typed.
#pragma once

#include "modal/mode_set/pairing.hpp"

#include <optional>
#include <string>

namespace tapfit::tui {

/// "2:3" (modes counted from 1), "2:none"; empty when it is neither.
[[nodiscard]] std::optional<modal::Pair> parse_pair(const std::string& text);

}  // namespace tapfit::tui
