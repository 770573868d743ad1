// Which files of a folder were made as a virtual test and are as they were
// made: truth.json lists them, each with a checksum (FNV-1a, 64 bits).
#pragma once

#include <nlohmann/json_fwd.hpp>

#include <cstdint>
#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

namespace tapfit::updating {

inline constexpr const char* truth_file = "truth.json";

/// FNV-1a of bytes.
[[nodiscard]] std::uint64_t checksum(std::string_view bytes);

/// The same as text: 16 hexadecimal digits.
[[nodiscard]] std::string checksum_text(std::string_view bytes);

/// Of a file; that of no bytes where it cannot be read.
[[nodiscard]] std::string checksum_of_file(const std::filesystem::path& file);

/// An object with every file of the folder by its name, and its checksum.
[[nodiscard]] nlohmann::ordered_json file_checksums(
    const std::filesystem::path& folder);

/// Adds the list to what truth.json is to hold: of all files that are in the
/// folder, and of the document itself.
void list_made_files(const std::filesystem::path& folder,
                     nlohmann::ordered_json& truth);

/// Those of the list that were not changed since. Empty without a truth.json of
/// this program, and where that was changed.
[[nodiscard]] std::vector<std::filesystem::path> made_files(
    const std::filesystem::path& folder);

}  // namespace tapfit::updating
