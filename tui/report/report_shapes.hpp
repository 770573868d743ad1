// The structure in pictures: the set-up, and mode shapes that swing.
#pragma once

#include "tui/document/document.hpp"
#include "tui/report/report_data.hpp"

#include <optional>

namespace tapfit::tui {

/// Hit points and sensors, and where something was found; nothing where no
/// place is known.
[[nodiscard]] std::optional<Figure> set_up_sketch(const ReportData& data);

/// Measured points over the last model's mode that each is paired with; without
/// a model at the places of the test's own points, or over their list.
[[nodiscard]] Section shape_section(const ReportData& data);

}  // namespace tapfit::tui
