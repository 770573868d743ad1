// The report's section on what each effect does for the model: where it sits,
// and the FRF with and without it.
#pragma once

#include "tui/document/document.hpp"
#include "tui/report/report_data.hpp"

#include <vector>

namespace tapfit::tui {

/// None where nothing was identified.
[[nodiscard]] std::vector<Section> evidence_sections(const ReportData& data);

}  // namespace tapfit::tui
