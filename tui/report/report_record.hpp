// The end of a report: how it was worked out, and from which files.
#pragma once

#include "tui/document/document.hpp"
#include "tui/report/report_data.hpp"

#include <vector>

namespace tapfit::tui {

/// Warnings; settings; version and SHA-256 digests of the files.
[[nodiscard]] std::vector<Section> record_sections(const ReportData& data);

}  // namespace tapfit::tui
