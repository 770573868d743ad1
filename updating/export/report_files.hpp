// Where a report goes: one file and, of Markdown, a folder of pictures beside
// it ("x-files" of x.md).
#pragma once

#include "acquisition/foundation/output_rule.hpp"

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace tapfit::updating {

/// What is wrong with a report's name: an ending of neither HTML (.html, .htm)
/// nor Markdown (.md, .markdown); empty where nothing is. Without an ending it
/// is HTML.
[[nodiscard]] std::string report_name_fault(
    const std::filesystem::path& report);

/// The folder of a report's pictures; empty for one that holds them itself: all
/// but files that end in .md or .markdown.
[[nodiscard]] std::optional<std::filesystem::path> pictures_folder(
    const std::filesystem::path& report);

/// What writing a report may replace: its own name, there or not, and whatever
/// is in the folder of its pictures.
[[nodiscard]] std::vector<std::filesystem::path> report_files(
    const std::filesystem::path& report);

/// As OutputRule::free_name, with a folder of pictures that is not there.
[[nodiscard]] std::filesystem::path free_report(
    const acquisition::OutputRule& rule, const std::filesystem::path& report);

/// @throws InputError for a name with a fault, and where the rule does not let
///   one of report_files()
void check_report(const acquisition::OutputRule& rule,
                  const std::filesystem::path& report);

}  // namespace tapfit::updating
