// What a report says of model and measurement: criteria with their limits,
// modes before and after, MAC, where the error is, the missing stiffness.
#pragma once

#include "tui/document/document.hpp"
#include "tui/report/report_data.hpp"

#include <vector>

namespace tapfit::tui {

/// Empty without a model.
[[nodiscard]] std::vector<Section> model_sections(const ReportData& data);

/// The criteria of one comparison, each the worst over its pairs of modes.
struct Correlation {
  double frequency_percent = 0.0;    ///< largest error of a frequency
  double mac = 1.0;                  ///< smallest
  double cross_orthogonality = 0.0;  ///< largest off the diagonal, 0..1
  std::size_t pairs = 0;
};

/// Cross-orthogonality is in the model's mass at the measured points: the root
/// of Comparison::weighted_mac, among the modes that are paired.
[[nodiscard]] Correlation correlation_of(
    const updating::Comparison& comparison);

}  // namespace tapfit::tui
