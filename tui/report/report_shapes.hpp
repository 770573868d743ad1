// Mode shapes as pictures that swing.
#pragma once

#include "tui/document/document.hpp"
#include "tui/report/report_data.hpp"
#include "tui/widgets/wireframe.hpp"

#include <optional>

namespace tapfit::tui {

/// Measured points over the last model's mode that each is paired with; without
/// a model the shape over the list of its points.
[[nodiscard]] Section shape_section(const ReportData& data);

/// The model's mesh, or the points of the test's own; nothing where no place is
/// known.
[[nodiscard]] std::optional<Wireframe> tested_structure(const ReportData& data);

}  // namespace tapfit::tui
