// The room tui/report. Results as text and as JSON, for the command line and
// for the written report.
// In:  Results of the rooms to the left.
// Out: Strings and files.
// May include: its row in CONTRIBUTING.md.
//
// The report of a test: what `tapfit report`, `w` on the Report screen and
// `tapfit session -o` write, from one document.
#pragma once

#include "acquisition/foundation/output_rule.hpp"
#include "tui/document/document.hpp"
#include "tui/report/report_data.hpp"

#include <string>

namespace tapfit::tui {

[[nodiscard]] Document report_document(const ReportData& data);

/// Its name where none is given, in the bundle's folder.
inline constexpr const char* usual_report = "report.html";

/// Writes it to one HTML file; to a file named .md or .markdown as Markdown,
/// with its pictures in a folder beside it (updating/export/report_files.hpp).
/// @throws InputError where it cannot be written, or the rule does not let one
/// of
///   its files: none is written then
void write_report(const Document& document,
                  const std::filesystem::path& path,
                  const acquisition::OutputRule& rule);

}  // namespace tapfit::tui
