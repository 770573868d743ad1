// What a report says of the measurement: set-up, hits, FRFs, modes.
#pragma once

#include "tui/document/document.hpp"
#include "tui/report/report_data.hpp"

#include <vector>

namespace tapfit::tui {

[[nodiscard]] std::vector<Section> measurement_sections(const ReportData& data);

}  // namespace tapfit::tui
