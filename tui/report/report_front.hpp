// A report's first page: for whoever asked for the test.
#pragma once

#include "tui/document/document.hpp"
#include "tui/report/report_data.hpp"

#include <vector>

namespace tapfit::tui {

/// The verdict, what was tested, an FRF measured, before and after; with a
/// model the error ladder beside it, what was identified, how sure, what to
/// measure next.
[[nodiscard]] std::vector<Section> front_sections(const ReportData& data);

}  // namespace tapfit::tui
