// tapfit reveal FOLDER: what a challenge hides, beside what was found in the
// terminal and what the program's own diagnosis says; both are judged by the
// rules of tapfit score.
#pragma once

#include "acquisition/foundation/progress.hpp"
#include "tui/options/command.hpp"

#include <string>

namespace tapfit::tui {

/// @return text, or one JSON object with `json`
/// @throws InputError where the folder holds no challenge, or its seal is
///   damaged or another test's; Stopped
[[nodiscard]] std::string reveal_command(const CommandOptions& options,
                                         const Progress& progress);

}  // namespace tapfit::tui
