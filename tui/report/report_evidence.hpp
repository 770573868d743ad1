// How sure the report's verdict is, what would tell more, and what each effect
// does for the model: where it sits, and the FRF with and without it.
#pragma once

#include "tui/document/document.hpp"
#include "tui/report/report_data.hpp"

#include <vector>

namespace tapfit::tui {

/// How probable what was found is, and what else it could be.
/// @param data with a model
[[nodiscard]] Section sure_section(const ReportData& data);

/// What would separate look-alikes, or why nothing is proposed.
/// @param data with a model
[[nodiscard]] Section next_section(const ReportData& data);

/// What becomes of the verdict when something is changed that was assumed, a
/// row for each; empty where that was not looked at.
[[nodiscard]] std::vector<Section> firmness_sections(const ReportData& data);

/// None where nothing was identified.
[[nodiscard]] std::vector<Section> evidence_sections(const ReportData& data);

}  // namespace tapfit::tui
