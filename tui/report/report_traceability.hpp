// What makes a test traceable: who made it, when and with what, and what of
// that test.json does not tell.
//
// Source: ISO/IEC 17025:2017, 6.4.13 (records of equipment: type, serial
// number, calibration and when the next is due) and 7.8.2 (reports).
#pragma once

#include "tui/document/document.hpp"
#include "tui/report/report_data.hpp"

#include <string>
#include <vector>

namespace tapfit::tui {

/// What speaks against a calibration, and what is not told: dates that do not
/// fit together where both are written as 2026-03 or 2026-03-01, then one
/// sentence of what is missing.
[[nodiscard]] std::vector<std::string> traceability_remarks(
    const ReportData& data);

/// The channels, and the remarks.
[[nodiscard]] std::vector<Part> traceability_parts(const ReportData& data);

}  // namespace tapfit::tui
