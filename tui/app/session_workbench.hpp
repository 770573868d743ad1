// The real workbench: a session over a test bundle.
#pragma once

#include "tui/workbench/workbench.hpp"

#include <filesystem>
#include <memory>

namespace tapfit::tui {

/// @throws InputError for a bundle that cannot be read
[[nodiscard]] std::unique_ptr<Workbench> open_session(
    const std::filesystem::path& bundle);

}  // namespace tapfit::tui
