// The criteria of correlation in a report: each at its worst and in each mode,
// and whether the limits of the test are kept.
#pragma once

#include "tui/document/document.hpp"
#include "tui/report/report_data.hpp"

#include <string>
#include <vector>

namespace tapfit::tui {

/// "Limits of the test: fail. MAC at least 0.9 is broken by 2 of 7 measured
/// modes, 0.812 (mode 3) the worst. Frequency within …": what is broken first.
/// @return empty where the test sets none or there is no model
[[nodiscard]] std::string criteria_sentence(const ReportData& data);

/// Each criterion at its worst before and after, and each mode before and
/// after. @param data with a model and at least one measured mode
[[nodiscard]] std::vector<Part> criteria_parts(const ReportData& data);

}  // namespace tapfit::tui
