// Findings as text and JSON.
#pragma once

#include "acquisition/bundle/test_bundle.hpp"
#include "acquisition/foundation/finding.hpp"

#include <nlohmann/json_fwd.hpp>

#include <string>
#include <vector>

namespace tapfit::tui {

/// What was seen, what it likely is and what to do, each on lines of its own;
/// "No check found a fault" where there are none.
[[nodiscard]] std::string findings_text(const std::vector<Finding>& findings);

/// [{"severity", "what", "where": {"run", "runs", "file", "channel", "hit",
/// "point"}, "likely", "remedy"}], numbers from 1; of `where` only what is
/// known, "run" and "file" of one run only, "runs" always with them.
[[nodiscard]] nlohmann::ordered_json findings_json(
    const acquisition::TestBundle& bundle,
    const std::vector<Finding>& findings);

}  // namespace tapfit::tui
