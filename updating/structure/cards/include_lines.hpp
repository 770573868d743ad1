// INCLUDE lines: which file they name, and how a file is named in one.
//
// Source: MSC Nastran Quick Reference Guide, "INCLUDE".
#pragma once

#include <filesystem>
#include <functional>
#include <istream>
#include <optional>
#include <string>
#include <vector>

namespace tapfit::structure {

/// The file that an INCLUDE of bulk data names; nothing for other lines.
[[nodiscard]] std::optional<std::string> include_name(const std::string& text);

/// Puts to an INCLUDE the next lines of its file, where its name goes on in
/// them.
///
/// @param number of the line, counted on
/// @return false where the file ends within the name
bool complete_include(std::istream& file, std::string& text, int& number);

/// The file that is meant: beside the one that asks, or beside the deck itself,
/// where solvers are started.
///
/// @param asks the file with the INCLUDE
/// @param main folder of the deck
/// @param exists on disk, where it is empty
[[nodiscard]] std::filesystem::path included(
    const std::filesystem::path& asks,
    std::string name,
    const std::filesystem::path& main,
    const std::function<bool(const std::filesystem::path&)>& exists = {});

/// INCLUDE lines for another file; of bulk data in 72 columns where its folders
/// let them.
/// @param text of the old ones, put together; a comment behind it stays
/// @param keyword whether it is *INCLUDE
[[nodiscard]] std::vector<std::string> renamed_include(const std::string& text,
                                                       const std::string& name,
                                                       bool keyword = false);

}  // namespace tapfit::structure
