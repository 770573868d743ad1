// What a report says of the measurement: set-up, hits, FRFs, modes.
#pragma once

#include "tui/document/document.hpp"
#include "tui/report/report_data.hpp"

#include <vector>

namespace tapfit::tui {

[[nodiscard]] std::vector<Section> measurement_sections(const ReportData& data);

/// Frequencies and damping with their deviations, and what speaks for each.
[[nodiscard]] DataTable mode_rows(const modal::ModeSet& modes);

}  // namespace tapfit::tui
