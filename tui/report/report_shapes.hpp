// Mode shapes as pictures that swing.
#pragma once

#include "tui/document/document.hpp"
#include "tui/report/report_data.hpp"

namespace tapfit::tui {

/// Measured points over the last model's mode that each is paired with; without
/// a model the shape over the list of its points.
[[nodiscard]] Section shape_section(const ReportData& data);

}  // namespace tapfit::tui
