// Which bundles were opened in the terminal, kept in the cache's folder.
#pragma once

#include <filesystem>
#include <vector>

namespace tapfit::tui {

/// Those that are there still, the latest first.
[[nodiscard]] std::vector<std::filesystem::path> recent_bundles();

/// Puts it before all others; where that cannot be kept, nothing is said.
void remember_bundle(const std::filesystem::path& bundle);

}  // namespace tapfit::tui
