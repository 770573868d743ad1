// Which build of the program is running: what is kept on disk is of one build.
#pragma once

#include <optional>
#include <string>

namespace tapfit::updating {

/// Size of the running program and when it was written; empty where the system
/// does not say.
[[nodiscard]] std::optional<std::string> program_stamp();

}  // namespace tapfit::updating
