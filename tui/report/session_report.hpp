// The room tui/report. Results as text and as JSON, for the command line and
// for the written report.
// In:  Results of the rooms to the left.
// Out: Strings.
// May include: its row in CONTRIBUTING.md.
//
// The work on a test as it stands, written down: what `w` on the Report screen
// and `tapfit session BUNDLE -o REPORT.md` give.
#pragma once

#include "updating/session/session.hpp"

#include <filesystem>
#include <string>

namespace tapfit::tui {

/// Markdown: hits, FRFs, modes; with a model the error ladder of what was
/// added, parameters, modes before and after, MAC before and after.
/// @throws InputError, Stopped
[[nodiscard]] std::string session_report(updating::Session& session,
                                         const Progress& progress);

/// @throws InputError where it cannot be written
void write_text_file(const std::string& text,
                     const std::filesystem::path& path);

}  // namespace tapfit::tui
