// Which files of a folder were made as a virtual test and are as they were
// made: truth.json lists them, each with a checksum (FNV-1a, 64 bits).
#pragma once

#include <nlohmann/json_fwd.hpp>

#include <filesystem>
#include <vector>

namespace tapfit::updating {

inline constexpr const char* truth_file = "truth.json";

/// Adds the list to what truth.json is to hold: of all files that are in the
/// folder, and of the document itself.
void list_made_files(const std::filesystem::path& folder,
                     nlohmann::ordered_json& truth);

/// Those of the list that were not changed since. Empty without a truth.json of
/// this program, and where that was changed.
[[nodiscard]] std::vector<std::filesystem::path> made_files(
    const std::filesystem::path& folder);

}  // namespace tapfit::updating
