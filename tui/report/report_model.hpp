// What a report says of model and measurement: criteria with their limits,
// modes before and after, MAC, where the error is, the missing stiffness.
#pragma once

#include "tui/document/document.hpp"
#include "tui/report/report_data.hpp"

#include <vector>

namespace tapfit::tui {

/// Empty without a model.
[[nodiscard]] std::vector<Section> model_sections(const ReportData& data);

}  // namespace tapfit::tui
