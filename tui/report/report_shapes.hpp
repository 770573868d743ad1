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
/// The structure of the model with that place marked in green, without a
/// caption; nothing where it is everywhere.
/// @pre the test has a model
[[nodiscard]] std::optional<Figure> place_figure(
    const ReportData& data,
    const updating::Location& where,
    const std::string& name);

[[nodiscard]] Section shape_section(const ReportData& data);

}  // namespace tapfit::tui
