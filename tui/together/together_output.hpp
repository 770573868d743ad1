// What `tapfit together` prints.
#pragma once

#include "updating/session/tests_together.hpp"

#include <nlohmann/json_fwd.hpp>

#include <string>
#include <vector>

namespace tapfit::tui {

/// {"tests": [..], "shared": [..], "converged", "message"}; see
/// docs/commands.md.
/// @param names of the tests
[[nodiscard]] nlohmann::ordered_json together_json(
    const updating::TestsTogether& found,
    const std::vector<std::string>& names);

[[nodiscard]] std::string together_text(const updating::TestsTogether& found,
                                        const std::vector<std::string>& names);

}  // namespace tapfit::tui
